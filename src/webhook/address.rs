//! Decides whether an address is public. Public addresses are those that IANA's special-purpose registries (RFC 6890
//! and its successors) mark as globally reachable. Addresses that map, translate or embed another address do not count
//! as public.

use std::net::{IpAddr, Ipv4Addr, Ipv6Addr};
use std::str::FromStr;

/// A network such as `10.0.0.0/8`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Network {
    address: IpAddr,
    prefix: u32,
}

impl Network {
    const fn v4(a: u8, b: u8, c: u8, prefix: u32) -> Self {
        Self { address: IpAddr::V4(Ipv4Addr::new(a, b, c, 0)), prefix }
    }

    const fn v6(a: u16, b: u16, c: u16, prefix: u32) -> Self {
        Self { address: IpAddr::V6(Ipv6Addr::new(a, b, c, 0, 0, 0, 0, 0)), prefix }
    }

    #[must_use]
    pub fn contains(&self, address: IpAddr) -> bool {
        match (self.address, address) {
            (IpAddr::V4(network), IpAddr::V4(address)) => {
                (network.to_bits() ^ address.to_bits()).checked_shr(32 - self.prefix).unwrap_or(0) == 0
            }
            (IpAddr::V6(network), IpAddr::V6(address)) => {
                (network.to_bits() ^ address.to_bits()).checked_shr(128 - self.prefix).unwrap_or(0) == 0
            }
            _ => false,
        }
    }
}

impl FromStr for Network {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let (address, prefix) = text.split_once('/').ok_or(())?;
        let address: IpAddr = address.parse().map_err(|_| ())?;
        let prefix = prefix.parse().map_err(|_| ())?;
        let longest = if address.is_ipv4() { 32 } else { 128 };
        if prefix <= longest { Ok(Self { address, prefix }) } else { Err(()) }
    }
}

const NOT_PUBLIC_V4: [Network; 16] = [
    // This network, and this host on it.
    Network::v4(0, 0, 0, 8),
    // Private.
    Network::v4(10, 0, 0, 8),
    // Shared by carriers (CGNAT).
    Network::v4(100, 64, 0, 10),
    // Loopback.
    Network::v4(127, 0, 0, 8),
    // Link-local; the metadata services of clouds.
    Network::v4(169, 254, 0, 16),
    // Private.
    Network::v4(172, 16, 0, 12),
    // Protocol assignments.
    Network::v4(192, 0, 0, 24),
    // Documentation.
    Network::v4(192, 0, 2, 24),
    // Relay anycast from 6to4 to IPv6.
    Network::v4(192, 88, 99, 24),
    // Private.
    Network::v4(192, 168, 0, 16),
    // Benchmarks.
    Network::v4(198, 18, 0, 15),
    // Documentation.
    Network::v4(198, 51, 100, 24),
    Network::v4(203, 0, 113, 24),
    // Multicast.
    Network::v4(224, 0, 0, 4),
    // Reserved, and broadcast.
    Network::v4(240, 0, 0, 4),
    // AS112, which answers for private names.
    Network::v4(192, 175, 48, 24),
];

/// Every public IPv6 address is in this network. The unspecified and loopback addresses are outside it, and so are
/// mapped (`::ffff:0:0/96`), translated (`64:ff9b::/96`, `64:ff9b:1::/48`), unique local (`fc00::/7`), link-local
/// (`fe80::/10`) and multicast (`ff00::/8`) addresses.
const UNICAST_V6: Network = Network::v6(0x2000, 0, 0, 3);

const NOT_PUBLIC_V6: [Network; 4] = [
    // Protocol assignments, including Teredo.
    Network::v6(0x2001, 0, 0, 23),
    // Documentation.
    Network::v6(0x2001, 0xdb8, 0, 32),
    Network::v6(0x3fff, 0, 0, 20),
    // 6to4, which embeds an IPv4 address.
    Network::v6(0x2002, 0, 0, 16),
];

#[must_use]
pub fn is_public(address: IpAddr) -> bool {
    let within = |networks: &[Network]| networks.iter().any(|network| network.contains(address));
    match address {
        IpAddr::V4(_) => !within(&NOT_PUBLIC_V4),
        IpAddr::V6(_) => UNICAST_V6.contains(address) && !within(&NOT_PUBLIC_V6),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn special_purpose_addresses_are_not_public() {
        for address in [
            "0.0.0.0",
            "0.1.2.3",
            "10.255.255.255",
            "100.64.0.1",
            "100.127.255.255",
            "127.0.0.1",
            "127.255.0.1",
            "169.254.169.254",
            "172.16.0.1",
            "172.31.255.255",
            "192.0.0.8",
            "192.0.2.1",
            "192.88.99.1",
            "192.168.1.1",
            "198.18.0.1",
            "198.19.255.255",
            "198.51.100.1",
            "203.0.113.1",
            "224.0.0.1",
            "239.255.255.255",
            "240.0.0.1",
            "255.255.255.255",
            "::",
            "::1",
            "::7f00:1",
            "::ffff:127.0.0.1",
            "::ffff:8.8.8.8",
            "64:ff9b::10.0.0.1",
            "64:ff9b::8.8.8.8",
            "64:ff9b:1::1",
            "100::1",
            "2001::1",
            "2001:db8::1",
            "2002:7f00:1::1",
            "3fff::1",
            "5f00::1",
            "fc00::1",
            "fd12:3456::1",
            "fe80::1",
            "fec0::1",
            "ff02::1",
        ] {
            assert!(!is_public(address.parse().unwrap()), "{address}");
        }
    }

    #[test]
    fn other_addresses_are_public() {
        for address in [
            "1.1.1.1",
            "9.255.255.255",
            "11.0.0.0",
            "100.63.255.255",
            "100.128.0.0",
            "126.255.255.255",
            "128.0.0.0",
            "169.253.255.255",
            "172.15.255.255",
            "172.32.0.0",
            "192.167.255.255",
            "192.169.0.0",
            "198.17.255.255",
            "198.20.0.0",
            "223.255.255.255",
            "2001:4860:4860::8888",
            "2606:4700::1111",
            "2a00:1450::1",
        ] {
            assert!(is_public(address.parse().unwrap()), "{address}");
        }
    }

    #[test]
    fn a_network_contains_exactly_the_addresses_with_its_prefix() {
        let network = |text: &str| text.parse::<Network>();
        assert!(network("10.0.0.0/8").unwrap().contains("10.9.8.7".parse().unwrap()));
        assert!(!network("10.0.0.0/8").unwrap().contains("11.0.0.0".parse().unwrap()));
        assert!(network("0.0.0.0/0").unwrap().contains("1.2.3.4".parse().unwrap()));
        assert!(!network("0.0.0.0/0").unwrap().contains("::1".parse().unwrap()));
        assert!(network("::1/128").unwrap().contains("::1".parse().unwrap()));
        assert!(!network("::1/128").unwrap().contains("::2".parse().unwrap()));
        for bad in ["10.0.0.0", "10.0.0.0/33", "::/129", "10.0.0/8", "a/8", "10.0.0.0/-1"] {
            assert!(network(bad).is_err(), "{bad}");
        }
    }
}
