//! Fuzzes the reader `recording`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    pelletflow_fuzz::read("recording", bytes);
});
