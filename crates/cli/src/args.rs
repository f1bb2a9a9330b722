//! What may stand on the command line.

pub(crate) mod accuracy;
pub(crate) mod card;
pub(crate) mod export;
pub(crate) mod hit;
pub(crate) mod impact;
pub(crate) mod quantity;
pub(crate) mod report;
pub(crate) mod safe_speed;
pub(crate) mod score;

use accuracy::AccuracyArguments;
use card::CardArguments;
use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;
use export::ExportArguments;
use impact::ImpactArguments;
use pelletflow_scene::{Override, TEMPLATES};
use report::ReportArguments;
use safe_speed::{MaterialsArguments, SafeSpeedArguments};
use score::ScoreArguments;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  pelletflow new hopper                  write a scene to start from: hopper.toml
  pelletflow check hopper.toml           find every mistake; show what a run will do
  pelletflow run hopper.toml             run it; results go to out/hopper
  pelletflow run hopper.toml --resume    go on with a run that was interrupted or killed
  pelletflow run hopper.toml --live      watch it in Foxglove or Lichtblick while it goes on
  pelletflow inspect out/hopper/run.mcap show what the recording holds
  pelletflow report out/hopper/run.mcap  write it as a page: plots, hits and a replay in space
  pelletflow score out/hopper/run.mcap --strength 2kN   tell which pellets break, where and by what
  pelletflow impact --figure 2           follow one hit, from 1 to 8 m/s, as in the paper
  pelletflow safe-speed --pellet fired-pellet --strength 2kN   tell how fast pellets may arrive
  pelletflow card --crush loads.csv -o card.toml               make a strength card of a lab sheet

Units: plain numbers in scenes and results are SI; scenes also take \"15 mm\", \"250 t/h\", \"60 MPa\", \"30 deg\".

Exit codes:
  0    done
  2    bad input: the command line, the scene, a missing file
  3    the physics failed, or an [expect] of the scene is not met
  4    reading or writing failed
  130  interrupted; `run --resume` goes on";

/// Simulates flows of iron-ore pellets through hoppers and chutes.
///
/// A scene is a TOML file that tells materials, pellets, equipment and time. A run writes a recording
/// that opens in Foxglove, Lichtblick and Rerun, and a summary in numbers.
#[derive(Debug, Parser)]
#[command(name = "pelletflow", version, about, after_help = EXAMPLES, subcommand_required = true, arg_required_else_help = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run a scene; write its recording and its summary.
    Run(RunArguments),
    /// Find every mistake in a scene; show what a run will do.
    Check(CheckArguments),
    /// Print the JSON Schema of a scene, for editors.
    #[command(after_help = "Example:
  pelletflow schema > scene.schema.json
  and as the first line of a scene, for editors that know Taplo:  #:schema ./scene.schema.json")]
    Schema,
    /// Write a commented scene to start from.
    New(NewArguments),
    /// Show what a recording holds.
    Inspect(InspectArguments),
    /// Tell which of the recorded hits break pellets of a strength: how many, where, and by what.
    Score(ScoreArguments),
    /// Write a recording as a page that opens in any browser: plots, hits and a replay in space.
    Report(ReportArguments),
    /// Write a recording as files of other programs: `ParaView`, spreadsheets, data frames.
    Export(ExportArguments),
    /// Follow one hit from first touch to release: force, time, pressure and the curves fitted to them.
    Impact(Box<ImpactArguments>),
    /// Tell how fast pellets may arrive before a share of them breaks.
    SafeSpeed(Box<SafeSpeedArguments>),
    /// Make a strength card of the sheets of a laboratory.
    Card(Box<CardArguments>),
    /// Run a scene over step sizes and integrators; show run time against error.
    Accuracy(AccuracyArguments),
    /// List the named materials with their sources.
    Materials(MaterialsArguments),
    /// Print completions for a shell.
    Completions(CompletionsArguments),
}

#[derive(Debug, Args)]
#[command(after_help = "\
Writes into the directory:
  run.mcap      recording, for Foxglove, Lichtblick and Rerun
  summary.json  the run in numbers, each key with its unit
  scene.toml    the scene as it was run, with every --set in it
  layout.json   what Foxglove and Lichtblick show, to be opened there beside the recording
  meters/       a table of patches for each meter that keeps them: `wall-impacts`, `wear`
  checkpoint.pf what --resume goes on from, until the run is over

Examples:
  pelletflow run hopper.toml
  pelletflow run hopper.toml -o out/wide --set walls.gate.opens_at=\"1 s\" --set fill.bed.count=2000
  pelletflow run hopper.toml --json --quiet | jq .contacts.max_force_n
  pelletflow run hopper.toml --profile   show where the time went
  pelletflow run hopper.toml --resume    go on with a run that was interrupted or killed

Ctrl-C ends the run after the current step; recording and summary are then written as for a finished run, with a
checkpoint beside them. Checkpoints are also written every 10 minutes (output.checkpoint_interval), so that a run that
was killed loses no more. --resume goes on from the newest and gives the same bits as a run that was never interrupted;
where there is none, it begins at the start.")]
pub(crate) struct RunArguments {
    /// Scene file.
    pub(crate) scene: PathBuf,
    /// Directory of the results [default: out/NAME, after the scene's name].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// Set a value of the scene; can be given more than once.
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) set: Vec<Override>,
    #[command(flatten)]
    pub(crate) earlier: EarlierArguments,
    /// Number of threads; all cores where it is left out. The result does not depend on it.
    #[arg(long, value_name = "N", value_parser = thread_count, allow_negative_numbers = true)]
    pub(crate) threads: Option<usize>,
    /// Let Foxglove or Lichtblick watch the run while it goes on, at a web socket [default: 127.0.0.1:8765, which only this
    /// machine reaches].
    #[arg(
        long,
        value_name = "HOST:PORT",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = pelletflow_log::LIVE_ADDRESS
    )]
    pub(crate) live: Option<String>,
    /// Print the summary as JSON, and nothing else on standard output.
    #[arg(long)]
    pub(crate) json: bool,
    /// Show where the time went, phase by phase; JSON holds it anyway, under `performance.phases`.
    #[arg(long)]
    pub(crate) profile: bool,
    /// Show no progress and no table but that of --profile.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// What is done with an unfinished run in the directory.
#[derive(Debug, Args)]
pub(crate) struct EarlierArguments {
    /// Go on with the unfinished run in the directory, to the same bits; begin at the start where there is none.
    #[arg(long, conflicts_with = "restart")]
    pub(crate) resume: bool,
    /// Drop the unfinished run in the directory and begin anew.
    #[arg(long)]
    pub(crate) restart: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  pelletflow check hopper.toml
  pelletflow check hopper.toml --set pellets.ore.diameter=\"12 mm\" --json
  pelletflow check hopper.toml --walls   drop one pellet onto each wall and compare with Hertz")]
pub(crate) struct CheckArguments {
    /// Scene file.
    pub(crate) scene: PathBuf,
    /// Set a value of the scene; can be given more than once.
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) set: Vec<Override>,
    /// Drop one pellet onto the face, an edge, a tip and a corner of each wall, where it has one, and compare the force with
    /// that of a plane.
    #[arg(long)]
    pub(crate) walls: bool,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  pelletflow new                       list the templates
  pelletflow new hopper                write hopper.toml
  pelletflow new chute -o plant.toml   write plant.toml
  pelletflow new drop -o -             write to standard output")]
pub(crate) struct NewArguments {
    /// Template; all are listed where none is named.
    #[arg(value_parser = PossibleValuesParser::new(TEMPLATES.iter().map(|template| template.name)))]
    pub(crate) template: Option<String>,
    /// File to write; never one that exists [default: TEMPLATE.toml].
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  pelletflow inspect out/hopper/run.mcap
  pelletflow inspect out/hopper/run.mcap --worst 20   list the hardest hits
  pelletflow inspect out/hopper/run.mcap --json | jq '.channels[].topic'")]
pub(crate) struct InspectArguments {
    /// Recording.
    pub(crate) recording: PathBuf,
    /// List the hardest hits, so many of them, in place of what the file holds.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) worst: Option<u32>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  pelletflow completions bash > ~/.local/share/bash-completion/completions/pelletflow
  pelletflow completions fish > ~/.config/fish/completions/pelletflow.fish")]
pub(crate) struct CompletionsArguments {
    /// Shell.
    pub(crate) shell: Shell,
}

/// More threads than any computer of today has cores [-].
const MOST_THREADS: usize = 1024;

fn thread_count(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(0) => Err("a run needs a thread; leave --threads out for all cores".into()),
        Ok(count) if count <= MOST_THREADS => Ok(count),
        Ok(_) => Err(format!(
            "expected at most {MOST_THREADS}; leave --threads out for all cores"
        )),
        Err(_) => Err("expected a number such as 4; leave --threads out for all cores".into()),
    }
}
