// Fixed neighbours: six in a triangular lattice, found across the period; contacts open and close
// by the step function; rows that slide through each other are noticed and told.
#include "native/dem/lattice_neighbours.hpp"
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr std::size_t columns = 8, rows = 6;

dem::Parameters lattice_parameters() {
    auto p = free_discs(law_variants[0], 1e-3);
    p.period_x = 2.0 * columns;
    p.contacts = dem::Contacts::lattice_neighbours;
    return p;
}

dem::State triangular_lattice() {
    dem::State s;
    for (std::size_t i = 0; i < columns * rows; ++i) {
        const std::size_t row = i / columns;
        add_disc(s, 2.0 * static_cast<double>(i % columns) + (row % 2 ? 1.0 : 0.0),
                 std::sqrt(3.0) * static_cast<double>(row), 0, 0);
    }
    return s;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_grain_of_a_triangular_lattice_has_six_neighbours) {
    const auto p = lattice_parameters();
    const auto s = triangular_lattice();
    const dem::LatticeNeighbours lattice(p, s.x, s.y);
    std::array<int, columns * rows> count{};
    for (const auto& pair : lattice.pairs()) {
        ++count[pair.i];
        ++count[pair.j];
    }
    for (std::size_t i = 0; i < count.size(); ++i) {
        const bool at_edge = i < columns || i >= columns * (rows - 1);
        BOOST_TEST(count[i] == (at_edge ? 4 : 6));
    }
}

BOOST_AUTO_TEST_CASE(as_long_as_none_slides_fixed_neighbours_are_all_neighbours) {
    auto p = lattice_parameters();
    auto s = triangular_lattice();
    for (std::uint64_t i = 0; i < s.x.size(); ++i) {
        const auto v = normal_pair(3, RandomStream::initial_velocity, i);
        s.vx[i] = 0.3 * v[0];
        s.vy[i] = 0.3 * v[1];
    }
    dem::Engine fixed(p, s);
    fixed.advance(500);
    p.contacts = dem::Contacts::neighbour_list;
    // The same forces in another order: round-off, amplified by collisions.
    BOOST_TEST(largest_difference(fixed.state(), after(p, s, 500)) < 1e-10);
    BOOST_TEST(fixed.missed_contacts().pairs == 0);
    BOOST_TEST(!fixed.missed_contacts().first_time.has_value());
}

BOOST_AUTO_TEST_CASE(fixed_neighbours_that_part_do_not_pull) {
    auto p = lattice_parameters();
    p.damping = 0;
    dem::State s;
    add_disc(s, 1, 0, -1, 0);
    add_disc(s, 3.1, 0, 1, 0);
    const auto end = after(p, s, 1000);
    BOOST_TEST(end.vx[0] == -1);
    BOOST_TEST(end.x[1] == 4.1, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(rows_that_slide_through_each_other_are_told) {
    // The upper row moves along the lower one, which it was not above at the start.
    auto p = lattice_parameters();
    p.period_x = 40;
    p.stiffness = 1e-6;
    p.damping = 0;
    dem::State s;
    add_disc(s, 10, 0, 0, 0);
    add_disc(s, 12, 0, 0, 0);
    add_disc(s, 14, 0, 0, 0);
    add_disc(s, 9, 1.7, 1, 0);
    dem::Engine engine(p, s);
    BOOST_TEST(engine.missed_contacts().pairs == 0);
    engine.advance(6000);
    const auto missed = engine.missed_contacts();
    // Grain 1 at 12 and grain 2 at 14 are strangers to grain 3; 0 is its neighbour.
    BOOST_TEST(missed.pairs == 2);
    const double half_chord = std::sqrt(4 - 1.7 * 1.7);
    BOOST_REQUIRE(missed.first_time.has_value());
    BOOST_TEST(std::abs(*missed.first_time - (12 - half_chord - 9)) < 2 * p.dt);
    p.contacts = dem::Contacts::neighbour_list;
    BOOST_TEST(dem::Engine(p, s).missed_contacts().pairs == 0);
}

BOOST_AUTO_TEST_CASE(a_cutoff_below_the_diameter_is_refused) {
    auto p = lattice_parameters();
    p.lattice_cutoff = 1.9;
    BOOST_CHECK_THROW(dem::Engine(p, triangular_lattice()), std::invalid_argument);
    p.lattice_cutoff = 2.1;
    BOOST_CHECK_NO_THROW(dem::Engine(p, triangular_lattice()));
}
