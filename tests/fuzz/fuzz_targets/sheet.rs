//! Fuzzes the reader `sheet`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    pelletflow_fuzz::read("sheet", bytes);
});
