// Whether LCM's datagrams can be sent and received on this machine, asked without LCM: where they
// cannot, liblcm prints a page of its own about it.
#pragma once

#include <string>

namespace shoal {

/// Joins LCM's group and sends an empty datagram to it, to a port that no program has. Returns an
/// empty text, or why multicast does not work, with the commands that help. Takes well under a
/// millisecond.
std::string MulticastFault();

}  // namespace shoal
