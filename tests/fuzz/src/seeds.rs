//! Bytes to begin with that only a run can make.

use crate::checkpoint;
use crate::file::folder;
use crate::plant::{SCENE, run_into};
use mcap::read::LinearReader;
use mcap::records::Record;
use mcap::{Attachment, MessageStream, WriteOptions};
use std::borrow::Cow;
use std::fs;
use std::io::Cursor;

/// Whole inputs of readers, each with the name of its reader and its own: what this version writes.
///
/// # Panics
/// No temporary folder can be made and written to.
pub fn seeds() -> Vec<(&'static str, &'static str, Vec<u8>)> {
    let folder = folder(&[]);
    run_into(folder.path(), &SCENE.plan, f64::INFINITY);
    let recording = fs::read(folder.path().join("run.mcap")).expect("the run has ended");
    let plain = plain(&recording);
    vec![
        ("recording", "good-packed", recording),
        ("recording", "good-plain", plain),
        ("checkpoint", "good", checkpoint::early_contents()),
    ]
}

/// A recording without compression and checksums, so that one changed byte of a message is read as such.
fn plain(recording: &[u8]) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let options = WriteOptions::new()
        .use_chunks(false)
        .compression(None)
        .calculate_chunk_crcs(false)
        .calculate_data_section_crc(false)
        .calculate_summary_section_crc(false)
        .calculate_attachment_crcs(false);
    let mut writer = options.create(&mut file).expect(IN_MEMORY);
    for record in LinearReader::new(recording).expect(WHOLE) {
        match record.expect(WHOLE) {
            Record::Metadata(metadata) => writer.write_metadata(&metadata),
            Record::Attachment { header, data, .. } => writer.attach(&Attachment {
                log_time: header.log_time,
                create_time: header.create_time,
                name: header.name,
                media_type: header.media_type,
                data: Cow::Owned(data.into_owned()),
            }),
            _ => Ok(()),
        }
        .expect(IN_MEMORY);
    }
    for message in MessageStream::new(recording).expect(WHOLE) {
        writer.write(&message.expect(WHOLE)).expect(IN_MEMORY);
    }
    writer.finish().expect(IN_MEMORY);
    drop(writer);
    file.into_inner()
}

const WHOLE: &str = "a recording that has just been written is whole";
const IN_MEMORY: &str = "memory can be written to";
