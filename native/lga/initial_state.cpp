#include "native/lga/initial_state.hpp"

#include "native/base/errors.hpp"
#include "native/lga/random_bits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace crossgrain::lga {
namespace {

struct Slot {
    int site = 0;
    int bit = 0;
};

/// States that particles have before a collision: at a wall, those that arrive.
std::vector<Slot> moving_states(const Geometry& geometry) {
    std::vector<Slot> slots;
    for (int column = 0; column < geometry.columns(); ++column) {
        for (int row = 0; row < geometry.rows(); ++row) {
            const int site = geometry.index({.column = column, .row = row});
            for (int i = 0; i < directions; ++i) {
                const int from = column - Geometry::column_step(i);
                const bool arrives = from != column && from >= 0 && from < geometry.columns();
                if (!geometry.is_wall(column) || arrives) slots.push_back({site, i});
            }
        }
    }
    return slots;
}

std::vector<Slot> rest_states(const Geometry& geometry) {
    std::vector<Slot> slots;
    for (int column = 1; column + 1 < geometry.columns(); ++column) {
        for (int row = 0; row < geometry.rows(); ++row) {
            slots.push_back({geometry.index({.column = column, .row = row}), rest_bit});
        }
    }
    return slots;
}

/// Uniform integers of one replica's filling.
class Shuffler {
  public:
    Shuffler(std::uint64_t seed, int replica)
        : keys_(seed, RandomUse::initial_state), replica_(static_cast<std::uint64_t>(replica)) {}

    /// In [0, n), n < 2^32; the bias is below 2^-32.
    std::size_t below(std::size_t n) {
        if (next_ % 4 == 0) blocks_ = random_blocks(keys_, {.low = next_, .high = replica_ << 32});
        const std::uint64_t u = blocks_[next_ % 4][0] >> 32;
        ++next_;
        return static_cast<std::size_t>((u * n) >> 32);
    }

    /// Moves a uniformly chosen set of `chosen` elements to the front (Fisher and Yates).
    void choose(std::span<Slot> slots, std::size_t chosen) {
        for (std::size_t i = 0; i < chosen; ++i) {
            std::swap(slots[i], slots[i + below(slots.size() - i)]);
        }
    }

  private:
    RoundKeys keys_;
    std::uint64_t replica_;
    std::uint64_t next_ = 0;
    Blocks blocks_{};
};

}  // namespace

std::int64_t particles(const Model& model) {
    if (!model.periodic) return 0;
    return std::llround(model.density * model.length * model.width);
}

std::vector<std::uint8_t> initial_state(const Model& model, int replica) {
    const Geometry geometry(model);
    std::vector<std::uint8_t> sites(static_cast<std::size_t>(geometry.sites()), 0);
    if (!model.periodic) return sites;
    auto moving = moving_states(geometry);
    auto resting = rest_states(geometry);
    const auto n = static_cast<std::size_t>(particles(model));
    if (n > moving.size() + resting.size()) {
        throw CaseError({.file = {},
                         .key = "scene.density",
                         .problem = "is more than the pipe can hold",
                         .got = fmt::format("{:g} ({} particles)", model.density, n),
                         .expected = fmt::format(
                             "at most {:g}", static_cast<double>(moving.size() + resting.size()) /
                                                 (static_cast<double>(model.length) * model.width)),
                         .hint = {}});
    }
    Shuffler shuffler(model.seed, replica);
    const std::size_t movers = std::min(n, moving.size());
    shuffler.choose(moving, movers);
    shuffler.choose(resting, n - movers);
    const auto fill = [&](const Slot& slot) {
        auto& site = sites[static_cast<std::size_t>(slot.site)];
        site = static_cast<std::uint8_t>(site | 1U << slot.bit);
    };
    std::for_each_n(moving.begin(), movers, fill);
    std::for_each_n(resting.begin(), n - movers, fill);
    return sites;
}

}  // namespace crossgrain::lga
