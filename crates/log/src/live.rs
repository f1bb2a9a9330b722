//! A run watched while it goes on: its channels on a web socket, as viewers know it.
//!
//! Each viewer is served by threads of the server from a queue of its own, which holds [`WAITING`] messages. What finds no
//! room there pushes the oldest out: a slow viewer misses frames, and neither slows the run nor grows it. Nobody can send
//! anything to the run.

use foxglove::websocket::{Capability, ChannelView, Client, ServerListener};
use foxglove::{
    ChannelBuilder, Context, FoxgloveError, PartialMetadata, RawChannel, Schema, WebSocketServer,
    WebSocketServerHandle,
};
use std::collections::BTreeMap;
use std::fmt;
use std::io;
use std::net::{SocketAddr, ToSocketAddrs};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};
use std::thread;
use std::time::Duration;

/// Where a run is shown when nothing else is asked for: to programs of this machine only.
pub const LIVE_ADDRESS: &str = "127.0.0.1:8765";

/// Messages that wait for a viewer at most [-]; of a frame there are some ten, of which one or two are large.
const WAITING: usize = 64;
/// How long the end of a run waits for viewers to hear of it.
const FAREWELL: Duration = Duration::from_millis(500);

/// A server that shows runs to viewers, until it is dropped.
pub struct Live {
    server: Server,
    address: SocketAddr,
    program: Program,
}

/// A server that is at work; nothing once it has been stopped.
type Server = Arc<Mutex<Option<WebSocketServerHandle>>>;

/// A server that could not be started.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LiveError {
    /// The address is none.
    #[error("`{asked}` is no address; expected HOST:PORT such as {LIVE_ADDRESS}{}", reason.as_ref().map_or_else(String::new, |reason| format!(": {reason}")))]
    Address {
        /// What was asked for.
        asked: String,
        /// What the system says of it.
        reason: Option<io::Error>,
    },
    /// Another program listens there, or the address is not of this machine.
    #[error(
        "cannot listen on {address}: {reason}; end what listens there, or choose another port with --live=HOST:PORT"
    )]
    Bind {
        /// What was asked for.
        address: SocketAddr,
        /// Why not.
        reason: String,
    },
}

impl Live {
    /// Listens on an address such as [`LIVE_ADDRESS`]; port 0 takes any that is free.
    ///
    /// # Errors
    /// It is no address, or another program listens there.
    pub fn start(asked: &str) -> Result<Self, LiveError> {
        let no_address = |reason| LiveError::Address {
            asked: asked.to_owned(),
            reason,
        };
        let mut addresses = asked
            .to_socket_addrs()
            .map_err(|error| no_address(Some(error)))?;
        let address = addresses.next().ok_or_else(|| no_address(None))?;
        let context = Context::new();
        let latest = Arc::new(Latest::default());
        let host = match address {
            SocketAddr::V4(address) => address.ip().to_string(),
            SocketAddr::V6(address) => format!("[{}]", address.ip()),
        };
        let server = WebSocketServer::new()
            .name(format!("pelletflow {}", env!("CARGO_PKG_VERSION")))
            .context(&context)
            .bind(host, address.port())
            .message_backlog_size(WAITING)
            .capabilities([Capability::Time])
            .listener(Arc::clone(&latest) as Arc<dyn ServerListener>)
            .start_blocking()
            .map_err(|error| LiveError::Bind {
                address,
                reason: match error {
                    FoxgloveError::Bind(error) => error.to_string(),
                    other => other.to_string(),
                },
            })?;
        let address = SocketAddr::new(address.ip(), server.port());
        let server = Arc::new(Mutex::new(Some(server)));
        Ok(Self {
            program: Program {
                context,
                latest,
                server: Arc::clone(&server),
            },
            address,
            server,
        })
    }

    /// Where viewers find it.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Viewers that are connected [-].
    pub fn viewers(&self) -> usize {
        at_work(&self.server)
            .as_ref()
            .map_or(0, WebSocketServerHandle::client_count)
    }

    /// What is shown there.
    pub(crate) fn program(&self) -> Program {
        self.program.clone()
    }
}

impl Drop for Live {
    fn drop(&mut self) {
        if let Some(server) = at_work(&self.server).take() {
            let stopping = server.stop();
            let (told, all_told) = mpsc::channel();
            thread::spawn(move || {
                stopping.wait_blocking();
                // Nobody may wait any more.
                let _ = told.send(());
            });
            // One that hears of nothing is left alone.
            let _ = all_told.recv_timeout(FAREWELL);
        }
    }
}

fn at_work(server: &Server) -> MutexGuard<'_, Option<WebSocketServerHandle>> {
    // Whatever panicked has left a server or none.
    server.lock().unwrap_or_else(PoisonError::into_inner)
}

impl fmt::Debug for Live {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Live")
            .field("address", &self.address)
            .finish_non_exhaustive()
    }
}

/// What a server shows: topics, and the last message of each.
#[derive(Clone)]
pub(crate) struct Program {
    context: Arc<Context>,
    latest: Arc<Latest>,
    server: Server,
}

impl Program {
    /// Announces a topic whose messages are protobuf.
    pub(crate) fn open(&self, topic: &str, schema: &Schema) -> Arc<RawChannel> {
        ChannelBuilder::new(topic)
            .context(&self.context)
            .message_encoding("protobuf")
            .schema(schema.clone())
            .build_raw()
            .expect("a topic with a schema and an encoding is a channel")
    }

    /// Sets the clock of all viewers [ns]: theirs would be that of the desk.
    pub(crate) fn set_time(&self, time: u64) {
        if let Some(server) = at_work(&self.server).as_ref() {
            server.broadcast_time(time);
        }
    }

    /// Tells a message of a log time [ns] to whoever follows its topic, and later to whoever comes to follow it.
    pub(crate) fn tell(&self, channel: &Arc<RawChannel>, time: u64, bytes: &[u8]) {
        let mut messages = self.latest.messages();
        channel.log_with_meta(bytes, stamped(time));
        let told = messages
            .entry(channel.topic().to_owned())
            .or_insert_with(|| Told {
                channel: Arc::clone(channel),
                time,
                bytes: Vec::new(),
            });
        told.time = time;
        told.bytes.clear();
        told.bytes.extend_from_slice(bytes);
    }
}

/// The last message of each topic: a viewer that comes late sees walls and pellets at once, not with the next frame.
///
/// One that is told in the moment of a subscription may come twice, which changes no picture.
#[derive(Default)]
struct Latest(Mutex<BTreeMap<String, Told>>);

struct Told {
    channel: Arc<RawChannel>,
    time: u64,
    bytes: Vec<u8>,
}

impl Latest {
    /// Held while a message is told, so that an older one never comes behind it.
    fn messages(&self) -> MutexGuard<'_, BTreeMap<String, Told>> {
        // Whatever panicked has left messages that are whole or of a moment that nobody sees.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl ServerListener for Latest {
    fn on_subscribe(&self, client: Client, channel: ChannelView) {
        let messages = self.messages();
        if let Some(told) = messages.get(channel.topic()) {
            let viewer = client.sink_id();
            told.channel
                .log_with_meta_to_sink(&told.bytes, stamped(told.time), viewer);
        }
    }
}

fn stamped(time: u64) -> PartialMetadata {
    PartialMetadata {
        log_time: Some(time),
    }
}

#[cfg(test)]
mod tests;
