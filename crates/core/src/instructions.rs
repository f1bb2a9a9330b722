//! Vector instructions: one source, compiled for several instruction sets, of which the machine's widest is chosen.
//!
//! No result depends on the choice: additions, products, quotients and square roots are rounded alike everywhere, and
//! nothing here is fused into one rounding.

#[cfg(target_arch = "x86_64")]
use pulp::{
    Simd, WithSimd,
    x86::{V3, V4},
};

/// Instructions that a processor may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InstructionSet {
    /// Those that every processor of its kind has.
    Baseline,
    /// AVX2: four numbers at a time.
    Avx2,
    /// AVX-512: eight numbers at a time.
    Avx512,
}

/// Work that is compiled for every instruction set.
///
/// All that [`run`](Self::run) calls must be inlined into it, or it keeps the instructions of the baseline.
pub trait Task {
    /// What it gives.
    type Output;

    /// Does the work; to be marked `#[inline(always)]`.
    fn run(self) -> Self::Output;
}

#[cfg(target_arch = "x86_64")]
struct Vectorized<T>(T);

#[cfg(target_arch = "x86_64")]
impl<T: Task> WithSimd for Vectorized<T> {
    type Output = T::Output;

    #[expect(
        clippy::inline_always,
        reason = "what is not inlined is not compiled for the instruction set"
    )]
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> T::Output {
        self.0.run()
    }
}

impl InstructionSet {
    /// All of them, the narrowest first.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// The widest that this machine has.
    pub fn widest() -> Self {
        let available = Self::ALL.into_iter().filter(|set| set.is_available());
        available.fold(Self::Baseline, |_, wider| wider)
    }
}

#[cfg(target_arch = "x86_64")]
impl InstructionSet {
    /// Whether this machine has it.
    pub fn is_available(self) -> bool {
        match self {
            Self::Baseline => true,
            Self::Avx2 => V3::try_new().is_some(),
            Self::Avx512 => V4::try_new().is_some(),
        }
    }

    /// Does work by these instructions, or by those of the baseline where the machine has none of these.
    #[inline]
    pub fn run<T: Task>(self, task: T) -> T::Output {
        match self {
            Self::Baseline => task.run(),
            Self::Avx2 => match V3::try_new() {
                Some(instructions) => Simd::vectorize(instructions, Vectorized(task)),
                None => task.run(),
            },
            Self::Avx512 => match V4::try_new() {
                Some(instructions) => Simd::vectorize(instructions, Vectorized(task)),
                None => task.run(),
            },
        }
    }
}

#[cfg(not(target_arch = "x86_64"))]
impl InstructionSet {
    /// Whether this machine has it.
    pub fn is_available(self) -> bool {
        self == Self::Baseline
    }

    /// Does work by the instructions of the baseline.
    #[inline]
    pub fn run<T: Task>(self, task: T) -> T::Output {
        task.run()
    }
}
