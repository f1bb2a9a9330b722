//! The same bits of every case, by every instruction set, on any number of threads, and from every build.

use crate::case::Case;
use crate::common::simulation_on;
use crate::{bodies, motions, piles};
use pelletflow::core::InstructionSet;

/// Steps taken of each case [-].
const STEPS: u64 = 600;

fn hash(case: &Case, instructions: InstructionSet, threads: usize) -> String {
    let mut setup = (case.setup)();
    setup.instructions = Some(instructions);
    let mut simulation = simulation_on(setup, threads);
    simulation.advance(STEPS).expect("the default step holds");
    simulation.state_hash()
}

#[test]
#[expect(
    clippy::print_stdout,
    reason = "`cargo xtask stress` compares what a development and a release build tell"
)]
fn every_instruction_set_gives_the_same_bits_of_every_case() {
    for case in bodies::CASES
        .iter()
        .chain(&piles::CASES)
        .chain(&motions::CASES)
    {
        let oracle = hash(case, InstructionSet::Baseline, 1);
        for (instructions, threads) in [(InstructionSet::Avx2, 2), (InstructionSet::Avx512, 4)] {
            if instructions.is_available() {
                let told = hash(case, instructions, threads);
                assert_eq!(told, oracle, "{} by {instructions:?}", case.name);
            }
        }
        println!("bits\t{}\t{oracle}", case.name);
    }
}
