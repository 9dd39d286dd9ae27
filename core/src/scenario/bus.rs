//! `bus ieee488 ...`: what is asked of the controller of the bus, and what it must have learnt.

use crate::bench::BusWait;
use crate::ieee488::{LAST_ADDRESS, Order};
use crate::time::Nanos;

use super::advance::Goal;
use super::runner::{Done, Runner};
use super::statement::{Action, BusAction};
use super::text::{Line, number, show, show_time};

/// Reads the statement behind `bus`.
pub(super) fn action(line: &mut Line<'_>) -> Result<Action, String> {
    let bus = line.need("the bus")?;
    let what = line.need("what to do on the bus")?;
    if bus != "ieee488" {
        while line.word().is_some() {}
        return Ok(Action::Needs(format!("{bus} bus")));
    }
    let order = match what {
        "ren" => Order::RemoteEnable(match line.need("`on` or `off`")? {
            "on" => true,
            "off" => false,
            word => return Err(format!("expected `on` or `off`, found `{word}`")),
        }),
        "ifc" => Order::InterfaceClear,
        "listen" => Order::Listen(addresses(line)?),
        "send" => Order::Send(line.bytes()?, line.eat("end")),
        "talk" => Order::Talk(address(line)?),
        "get" => Order::Trigger(addresses(line)?),
        "sdc" => {
            let mut addresses = addresses(line)?;
            if addresses.is_empty() {
                addresses.push(address(line)?);
            }
            Order::Clear(addresses)
        }
        "dcl" => Order::Clear(Vec::new()),
        "gtl" => Order::GoToLocal(addresses(line)?),
        "llo" => Order::LocalLockout,
        _ => return question(what, line).map(Action::Bus),
    };
    Ok(Action::Bus(BusAction::Order(order)))
}

/// Statements that compare something.
fn question(what: &str, line: &mut Line<'_>) -> Result<BusAction, String> {
    Ok(match what {
        "spoll" => poll(Order::SerialPoll(address(line)?), line)?,
        "ppoll" => poll(Order::ParallelPoll, line)?,
        "srq" => match expected(line)? {
            None => BusAction::UntilService {
                within: line.within()?,
            },
            Some(level @ (0 | 1)) => BusAction::Service(level == 1),
            Some(level) => return Err(format!("`{level}` is not a level: 0 or 1")),
        },
        "expect" if line.eat("nothing") => BusAction::Expect {
            bytes: Vec::new(),
            end: false,
        },
        "expect" => BusAction::Expect {
            bytes: line.bytes()?,
            end: line.eat("end"),
        },
        _ => {
            return Err(format!(
                "`{what}` is none of ren ifc listen send talk get sdc dcl gtl llo spoll ppoll srq expect"
            ));
        }
    })
}

fn poll(order: Order, line: &mut Line<'_>) -> Result<BusAction, String> {
    Ok(BusAction::Poll {
        order,
        expected: expected(line)?,
        within: line.within()?,
    })
}

/// `= 0x40`, or nothing.
fn expected(line: &mut Line<'_>) -> Result<Option<u8>, String> {
    if !line.eat("=") {
        return Ok(None);
    }
    let word = line.need("the byte")?;
    let byte =
        number(word).filter(|byte| libm::trunc(*byte) == *byte && (0.0..256.0).contains(byte));
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, and 0 to 255
    let byte = byte.map(|byte| byte as u8);
    match byte {
        Some(byte) => Ok(Some(byte)),
        None => Err(format!("`{word}` is not a byte")),
    }
}

fn address(line: &mut Line<'_>) -> Result<u8, String> {
    let word = line.need("the address")?;
    let address = word.parse().ok().filter(|address| *address <= LAST_ADDRESS);
    address.ok_or_else(|| format!("`{word}` is not an address of 0 to {LAST_ADDRESS}"))
}

fn addresses(line: &mut Line<'_>) -> Result<Vec<u8>, String> {
    let mut addresses = Vec::new();
    while line.peek().is_some() {
        addresses.push(address(line)?);
    }
    Ok(addresses)
}

impl Runner<'_> {
    pub(super) fn bus(&mut self, station: usize, action: &BusAction) -> Done {
        if self.controller(station)?.ieee488().is_none() {
            return Err(self.has_no(station, "ieee488 bus"));
        }
        match action {
            BusAction::Order(order) => self.order(order),
            BusAction::Poll {
                order,
                expected,
                within,
            } => self.poll(order, *expected, *within),
            BusAction::UntilService { within } => {
                if self.advance(*within, &mut Goal::Service)? {
                    return Ok(());
                }
                let why = self.busy().unwrap_or_else(|| "all is idle".to_owned());
                let within = show_time(*within);
                Err(format!("no unit requests service within {within}: {why}").into())
            }
            BusAction::Service(expected) => {
                let service = self.state.bench.bus().is_some_and(|bus| bus.service);
                match (*expected, service) {
                    (true, false) => Err("no unit requests service".to_owned().into()),
                    (false, true) => Err("a unit requests service".to_owned().into()),
                    _ => Ok(()),
                }
            }
            BusAction::Expect { bytes, end } => self.expect_on_bus(bytes, *end),
        }
    }

    fn order(&mut self, order: &Order) -> Done {
        let given = self.state.bench.order(order);
        given.map_err(|refused| refused.0.into())
    }

    fn poll(&mut self, order: &Order, expected: Option<u8>, within: Nanos) -> Done {
        self.order(order)?;
        if !self.advance(within, &mut Goal::Bus)? {
            let why = self.bus_waits().unwrap_or_default();
            return Err(format!("no poll within {}: {why}", show_time(within)).into());
        }
        let Some(found) = self.state.bus.polled else {
            return Err("no unit has that address".to_owned().into());
        };
        match expected.filter(|expected| *expected != found) {
            None => Ok(()),
            Some(expected) => {
                Err(format!("expected 0x{expected:02X}, the poll gave 0x{found:02X}").into())
            }
        }
    }

    fn expect_on_bus(&mut self, bytes: &[u8], end: bool) -> Done {
        let heard = &mut self.state.bus;
        if heard.bytes != bytes {
            let (expected, found) = (show(bytes), show(&heard.bytes));
            return Err(format!("expected {expected} on the bus, there was {found}").into());
        }
        if !bytes.is_empty() && heard.ended != end {
            let message = match end {
                true => "the last byte came without EOI",
                false => "the last byte came with EOI",
            };
            return Err(message.to_owned().into());
        }
        heard.bytes.clear();
        Ok(())
    }

    /// What keeps the controller of the bus from going on.
    pub(super) fn bus_waits(&self) -> Option<String> {
        match self.state.bench.bus()?.waits? {
            BusWait::NoListener => Some("no one listens on the bus".to_owned()),
            BusWait::Station(index) => {
                let name = self.scenario.stations.get(index).map(|s| s.name.as_str());
                Some(format!("{} holds off the bus", name.unwrap_or_default()))
            }
        }
    }
}
