//! `--live`: what is said to whoever wants to watch.

use crate::args::RunArguments;
use crate::exit::Failure;
use crate::screen;
use pelletflow_log::Live;
use std::path::Path;

/// Says where the run can be watched, and warns where others can as well.
pub(super) fn invite(
    live: &Live,
    directory: &Path,
    arguments: &RunArguments,
) -> Result<(), Failure> {
    let address = live.address();
    if !address.ip().is_loopback() {
        screen::remark(&format!(
            "warning: whoever reaches {address} over the network can watch this run; leave the address of --live out to let \
             only this machine"
        ));
    }
    let invitation = format!(
        "watch at ws://{address} in Foxglove or Lichtblick, with the layout {}",
        directory.join("layout.json").display()
    );
    if arguments.json || arguments.quiet {
        // Standard output holds the summary and nothing else.
        screen::remark(&invitation);
        Ok(())
    } else {
        screen::result(&invitation)
    }
}
