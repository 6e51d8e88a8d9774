// An ensemble of independent replicas of one lattice gas, advanced together. Two engines, the same
// bits replica by replica: plain tables (the readable reference) and bit slices (fast).
#pragma once

#include "native/lga/geometry.hpp"
#include "native/lga/model.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace crossgrain::lga {

/// What is asked for, per bin and replica.
struct Fields {
    bool count = true;
    bool rests = false;
    bool momentum = false;
};

/// Arrays of shape (bins, replicas), the replica running fastest; empty if not asked for.
struct BinValues {
    std::vector<std::uint16_t> count;    ///< particles, walls included
    std::vector<std::uint16_t> rests;    ///< of these, at rest
    std::vector<std::int16_t> momentum;  ///< downward velocities, in half sites per step
};

class Ensemble {
  public:
    virtual ~Ensemble() = default;
    Ensemble(const Ensemble&) = delete;
    Ensemble& operator=(const Ensemble&) = delete;

    /// Advances by `steps`. Ends early, after the step in which it happened, when relocation found
    /// no place for all particles at rest in some replica.
    virtual void advance(std::int64_t steps) = 0;
    /// Steps done.
    [[nodiscard]] virtual std::int64_t step() const = 0;
    /// Which replicas are saturated, 0 or 1; empty as long as none is. A saturated ensemble cannot
    /// be advanced; its rest particles that found no place are where their walk ended.
    [[nodiscard]] virtual const std::vector<std::uint8_t>& saturated() const = 0;
    /// `bin` sites along the pipe per bin, a divisor of its length.
    virtual void measure(int bin, const Fields& fields, BinValues& values) const = 0;
    /// Packed state of one site: movers in bits 0..5, the rest particle in bit 6.
    [[nodiscard]] virtual std::uint8_t site(int replica, Site site) const = 0;
    /// Whether collisions run as code of a shipped reading, which is faster; the bits are the same.
    [[nodiscard]] virtual bool is_compiled() const = 0;

  protected:
    Ensemble() = default;
};

/// One replica after the other, by table.
/// Throws CaseError for rules that do not conserve, or more particles than the pipe can hold.
[[nodiscard]] std::unique_ptr<Ensemble> make_table_ensemble(const Model& model);

/// Bit slices in words of `word_bits`, one of word_widths(). Throws as the other one does.
[[nodiscard]] std::unique_ptr<Ensemble> make_sliced_ensemble(const Model& model, int word_bits);

/// Widths of words that this processor has: 64, and 256 and 512 where it can.
[[nodiscard]] std::vector<int> word_widths();
/// The fastest width for so many replicas.
[[nodiscard]] int best_word_width(int replicas);

}  // namespace crossgrain::lga
