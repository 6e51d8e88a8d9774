// Carries the springs of contacts from one neighbour list to the next, whatever the order of the
// grains and of the two partners in either.
#pragma once

#include "native/friction/contact_law.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::friction {

class ContactCarrier {
  public:
    explicit ContactCarrier(std::size_t grains);

    void clear();
    /// `memory` is that of the force on grain i.
    void keep(std::uint32_t i, std::uint32_t j, const ContactMemory& memory);
    /// The memory of this pair for the force on grain i; all zero when none was kept.
    [[nodiscard]] ContactMemory find(std::uint32_t i, std::uint32_t j) const;

  private:
    struct Kept {
        std::uint32_t other;
        std::uint32_t next;
        ContactMemory memory;
    };
    static constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> first_;  ///< shape (grains): of a list per lower grain of a pair
    std::vector<Kept> kept_;
};

}  // namespace crossgrain::friction
