//! Viewers that come late, read slowly, or find no server.

use super::{Live, LiveError, Program, WAITING};
use foxglove::{RawChannel, Schema};
use serde_json::{Value, json};
use std::net::TcpStream;
use std::sync::Arc;
use std::thread;
use std::time::Duration;
use tungstenite::{ClientRequestBuilder, Message, WebSocket};

/// A viewer that waits for a message longer than this has been forgotten.
const PATIENCE: Duration = Duration::from_mins(1);

struct Viewer(WebSocket<TcpStream>);

impl Viewer {
    fn connect(live: &Live) -> Self {
        let address = format!("ws://{}", live.address());
        let request = ClientRequestBuilder::new(address.parse().expect("it is an address"))
            .with_sub_protocol("foxglove.sdk.v1");
        let stream = TcpStream::connect(live.address()).expect("the server listens");
        stream
            .set_read_timeout(Some(PATIENCE))
            .expect("it is some time");
        let (socket, _) = tungstenite::client(request, stream).expect("they speak the same");
        Self(socket)
    }

    fn read(&mut self) -> Message {
        self.0.read().expect("there is something to read")
    }

    /// The next message in words, of a kind.
    fn told(&mut self, kind: &str) -> Value {
        loop {
            if let Message::Text(text) = self.read() {
                let told: Value = serde_json::from_str(&text).expect("it is JSON");
                if told["op"] == kind {
                    return told;
                }
            }
        }
    }

    fn subscribe(&mut self, channel: &Value) {
        let subscriptions = json!([{ "id": 7, "channelId": channel }]);
        let asked = json!({ "op": "subscribe", "subscriptions": subscriptions });
        self.0
            .send(Message::text(asked.to_string()))
            .expect("the server listens");
    }

    /// Log time [ns] and bytes of the next message of a topic.
    fn message(&mut self) -> (u64, Vec<u8>) {
        loop {
            if let Message::Binary(bytes) = self.read() {
                // Operation, subscription and time stand before the message.
                assert_eq!(bytes[..5], [1, 7, 0, 0, 0]);
                let time = bytes[5..13].try_into().expect("these are eight");
                return (u64::from_le_bytes(time), bytes[13..].to_vec());
            }
        }
    }
}

fn server() -> Live {
    Live::start("127.0.0.1:0").expect("there is a free port")
}

fn topic(program: &Program) -> Arc<RawChannel> {
    let schema = Schema::new("pelletflow.Test", "protobuf", vec![1, 2, 3]);
    program.open("/test", &schema)
}

#[test]
fn a_viewer_that_comes_late_is_told_the_topics_and_the_last_message() {
    let live = server();
    let program = live.program();
    let channel = topic(&program);
    program.tell(&channel, 10, b"first");
    program.tell(&channel, 20, b"second");

    let mut viewer = Viewer::connect(&live);
    let info = viewer.told("serverInfo");
    // It can ask for nothing, and change nothing; the clock is that of the run.
    assert_eq!(info["capabilities"], json!(["time"]));
    let advertised = viewer.told("advertise")["channels"][0].clone();
    assert_eq!(advertised["topic"], "/test");
    assert_eq!(advertised["encoding"], "protobuf");
    assert_eq!(advertised["schemaName"], "pelletflow.Test");
    viewer.subscribe(&advertised["id"]);
    assert_eq!(viewer.message(), (20, b"second".to_vec()));
    program.tell(&channel, 30, b"third");
    assert_eq!(viewer.message(), (30, b"third".to_vec()));
}

#[test]
fn a_viewer_that_does_not_read_misses_messages_but_not_the_last() {
    // Far more than the queue, the system's buffers of a few MB and the message at work hold.
    const MESSAGES: u64 = 16 * WAITING as u64;
    let live = server();
    let program = live.program();
    let channel = topic(&program);
    program.tell(&channel, 0, b"");
    let mut viewer = Viewer::connect(&live);
    let advertised = viewer.told("advertise");
    viewer.subscribe(&advertised["channels"][0]["id"]);
    assert_eq!(viewer.message().0, 0);

    let bytes = vec![0; 128 * 1024];
    for time in 1..=MESSAGES {
        program.tell(&channel, time, &bytes);
    }
    let (mut read, mut last) = (0, 0);
    while last < MESSAGES {
        let (time, _) = viewer.message();
        assert!(time > last, "{time} comes after {last}");
        (read, last) = (read + 1, time);
    }
    assert!(read < MESSAGES / 2, "{read} of {MESSAGES} waited");
}

#[test]
fn a_port_that_is_in_use_is_refused_and_so_is_what_is_no_address() {
    let live = server();
    let address = live.address().to_string();
    let error = Live::start(&address).expect_err("it is in use");
    assert!(matches!(error, LiveError::Bind { .. }));
    assert!(error.to_string().contains(&address), "{error}");
    let error = Live::start("hopper.toml").expect_err("it is a file");
    assert!(matches!(error, LiveError::Address { .. }));
    assert!(error.to_string().contains("`hopper.toml`"), "{error}");
}

#[test]
fn the_port_is_free_again_once_the_server_is_gone() {
    let live = server();
    let address = live.address();
    let mut viewer = Viewer::connect(&live);
    viewer.told("serverInfo");
    assert_eq!(live.viewers(), 1);
    drop(live);
    // The viewer is told, so that it does not wait forever.
    while viewer.0.read().is_ok_and(|message| !message.is_close()) {}
    // The port is given up by another thread of the server.
    let is_free = || TcpStream::connect(address).is_err();
    let waits = (0..6000).map(|_| thread::sleep(PATIENCE / 6000));
    assert!(is_free() || waits.into_iter().any(|()| is_free()));
}
