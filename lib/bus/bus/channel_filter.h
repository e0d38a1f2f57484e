// A program for the kernel's socket filter (classic BPF) that accepts LCM datagrams of chosen
// channels: a process does not wake up for what it did not subscribe to.
//
// The names are compared word by word, as a tree: load four bytes of the channel, go on where a
// name has them. Where the program would be too long only the beginnings of names count, so the
// receiver compares once more. Fragments (LC03) are accepted all: only the first has the name.
#pragma once

#include <linux/filter.h>

#include <cstddef>
#include <string>
#include <vector>

namespace shoal {

/// Returns a program of at most `max_instructions` that accepts every datagram whose channel is one
/// of `names`; the others it refuses, as far as that many instructions can distinguish them. Empty:
/// they cannot; attach no filter.
/// @pre no name is empty
std::vector<sock_filter> ChannelFilter(const std::vector<std::string>& names,
                                       size_t max_instructions);

}  // namespace shoal
