// The rules of Gremaud, section 2, as they are written: each site of a level is visited in a random
// order, and each candidate's energy is worked out. The oracle of fast_engine.hpp.
#pragma once

#include "native/hopper/energy.hpp"
#include "native/hopper/engine.hpp"
#include "native/hopper/filling.hpp"
#include "native/hopper/numbers.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::hopper {

class PlainEngine final : public Engine {
  public:
    /// Throws CaseError, see check().
    explicit PlainEngine(const Parameters& parameters);

    void advance(std::int64_t iterations) override;
    [[nodiscard]] const Geometry& geometry() const override { return filling_.geometry; }
    [[nodiscard]] std::vector<std::uint8_t> state() const override { return filling_.sites(); }
    [[nodiscard]] const Record& record() const override { return filling_.record; }

  private:
    struct Site {
        std::int32_t k = 0, c = 0;
        std::uint32_t number = 0;  ///< level by level, columns ascending
    };
    /// What is visited together, by number: one half-level, or a zigzag row of two.
    using Row = std::vector<Site>;

    void iterate();
    /// Fills order_ with a permutation of the row.
    void shuffle(const Row& row);
    void fill(const Site& hole);
    [[nodiscard]] Cell cell_around(const Site& site) const;
    /// Least energy, at random among near ties.
    [[nodiscard]] Candidate choose_move(const Site& hole, const Cell& iloc,
                                        const std::vector<Candidate>& candidates);
    [[nodiscard]] std::uint32_t tie_number(const Site& hole);
    void note_vacated(std::int32_t k, std::int32_t c);

    Parameters parameters_;
    Energies energies_;
    Numbers numbers_;
    Filling filling_;
    std::vector<Row> rows_;             // in the order of the sweep
    std::vector<std::uint64_t> order_;  // random number above, index in the row below 2^32
    std::uint64_t stream_place_ = 0;    // next number of the shared stream
};

}  // namespace crossgrain::hopper
