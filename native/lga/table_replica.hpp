// One replica of the lattice gas, site by site: the readable reference of the bit-sliced engine.
#pragma once

#include "native/lga/collision_table.hpp"
#include "native/lga/geometry.hpp"
#include "native/lga/model.hpp"
#include "native/lga/random_bits.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::lga {

class TableReplica {
  public:
    TableReplica(const Model& model, int replica);

    /// Collide (wall sites reflect), relocate rests beyond one, gravity, propagate.
    void advance();

    /// Particles at rest found no place in the last step.
    [[nodiscard]] bool saturated() const noexcept { return saturated_; }
    /// Packed sites, shape (columns, rows).
    [[nodiscard]] const std::vector<std::uint8_t>& sites() const noexcept { return sites_; }
    /// Rests beyond one per site, shape (columns, rows); all 0 unless saturated.
    [[nodiscard]] const std::vector<std::uint16_t>& excess() const noexcept { return excess_; }

  private:
    /// Excess rests that return to where their particles came from.
    struct Return {
        Site site;
        std::uint8_t origins;
    };

    void collide();
    void collide_at(Site site);
    void reflect_at(Site site);
    void relocate();
    void return_to_origins();
    [[nodiscard]] bool hop(std::int64_t round);
    void kick();
    void kick_at(Site site);
    void inject();
    void propagate();

    /// The next of a decision's bits, four at a time.
    [[nodiscard]] unsigned four_bits(Draw draw, int offset, int site) const;
    /// u < value, with u the uniform number of this draw.
    [[nodiscard]] bool decide(std::uint32_t value, Draw draw, int offset, int site) const;
    [[nodiscard]] const Outcome& outcome(std::uint8_t state, int site) const;

    [[nodiscard]] std::uint8_t& at(Site site) {
        return sites_[static_cast<std::size_t>(geometry_.index(site))];
    }

    Model model_;
    Geometry geometry_;
    CollisionTable table_;
    RoundKeys keys_;
    std::uint32_t gravity_, roughness_, injection_;
    std::uint32_t block_;  ///< of this replica, with its place in it
    int word_;
    int bit_;
    std::int64_t step_ = 0;
    bool saturated_ = false;
    std::vector<std::uint8_t> sites_, next_;
    std::vector<std::uint16_t> excess_, arrivals_;
    std::vector<Return> returns_;
    std::vector<int> walkers_;  ///< sites with excess rests
};

}  // namespace crossgrain::lga
