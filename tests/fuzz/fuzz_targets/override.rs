//! Fuzzes the reader `override`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    pelletflow_fuzz::read("override", bytes);
});
