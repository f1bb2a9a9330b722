//! What LAMMPS and LIGGGHTS write down of a run; their logs have the same form.

use super::race::Outcome;

/// The word that a script prints before the part that counts.
pub(crate) const MEASURE: &str = "MEASURE";
/// The word that a script prints before the number of pellets that left.
pub(crate) const LEFT: &str = "LEFT";

/// Time and end of the part that counts; none where the run did not get there.
pub(crate) fn parsed(log: &str) -> Option<Outcome> {
    // Scripts are echoed: the last line that is the word alone is the printed one.
    let (_, measured) = log.rsplit_once(&format!("\n{MEASURE}\n"))?;
    let (seconds, pellet_steps) = measured.lines().find_map(loop_time)?;
    let kinetic = measured
        .lines()
        .take_while(|line| loop_time(line).is_none())
        .filter_map(kinetic_energy)
        .last()?;
    let left = measured
        .lines()
        .filter_map(|line| line.strip_prefix(LEFT)?.trim().parse().ok())
        .next_back();
    Some(Outcome {
        seconds,
        kinetic,
        left: left.unwrap_or(0.0),
        pellet_steps,
    })
}

/// Seconds and pellet-steps of `Loop time of 2.5 on 1 procs for 1000 steps with 10000 atoms`.
fn loop_time(line: &str) -> Option<(f64, f64)> {
    let (seconds, rest) = line.strip_prefix("Loop time of ")?.split_once(' ')?;
    let words: Vec<&str> = rest.split(' ').collect();
    let before = |name: &str| -> Option<f64> {
        let at = words.iter().position(|word| word.starts_with(name))?;
        words.get(at.checked_sub(1)?)?.parse().ok()
    };
    Some((seconds.parse().ok()?, before("steps")? * before("atoms")?))
}

/// The last number of a row of step, pellets and kinetic energy.
fn kinetic_energy(line: &str) -> Option<f64> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [step, pellets, kinetic] = words[..] else {
        return None;
    };
    let _: (u64, u64) = (step.parse().ok()?, pellets.parse().ok()?);
    kinetic.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAMMPS: &str = "\
run 200
Loop time of 9 on 1 procs for 200 steps with 9 atoms
print \"MEASURE\"
MEASURE
run 400
   Step      Atoms        KinEng
       200      10000   0.0012
       600      10000   0.0010000000
Loop time of 1.25 on 2 procs for 400 steps with 10000 atoms

99.1% CPU use with 2 MPI tasks x no OpenMP threads
variable left equal 3
print \"LEFT ${left}\"
LEFT 3
Total wall time: 0:00:02
";

    #[test]
    fn time_and_end_are_those_of_the_part_that_counts() {
        let outcome = parsed(LAMMPS).expect("a whole log");
        assert_eq!(outcome.seconds, 1.25);
        assert_eq!(outcome.kinetic, 1.0e-3);
        assert_eq!(outcome.left, 3.0);
        assert_eq!(outcome.pellet_steps, 4.0e6);
    }

    #[test]
    fn the_log_of_liggghts_is_read_alike() {
        let log = "\nMEASURE\nSetting up run ...\n    Step    Atoms         KinEng \n     500    10000 0.0016\n    1500    10000 0.00104\n\
                   Loop time of 3.2 on 1 procs for 1000 steps with 10000 atoms, finish time Sat Nov 21 2026\n";
        let outcome = parsed(log).expect("a whole log");
        assert_eq!((outcome.seconds, outcome.kinetic), (3.2, 1.04e-3));
        assert_eq!(outcome.pellet_steps, 1.0e7);
    }

    #[test]
    fn a_run_that_ended_early_has_no_time() {
        let (early, _) = LAMMPS.split_once("Loop time of 1.25").expect("the mark");
        assert_eq!(parsed(early), None);
        assert_eq!(parsed("ERROR: Unknown pair style"), None);
    }
}
