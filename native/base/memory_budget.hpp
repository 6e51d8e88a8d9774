// How much memory one run may ask for. Sizes that an input asks for are computed and held against
// it before anything is allocated.
#pragma once

#include <string>
#include <string_view>

namespace crossgrain {

/// Bytes: 8 GiB, what the machine has, or what the process is limited to, whichever is least.
[[nodiscard]] double memory_budget();

/// Throws std::invalid_argument ("... need 46.1 GiB, of at most 8 GiB") when `what` needs more.
/// Not a number counts as more.
void require_memory(double bytes, std::string_view what);

/// "46.1 GiB", "12 KiB", for messages; any number >= 0.
[[nodiscard]] std::string shown_bytes(double bytes);

}  // namespace crossgrain
