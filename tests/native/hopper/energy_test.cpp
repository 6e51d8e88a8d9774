// The energy of a cell, term by term against cells worked out by hand, and as exact integers.
#include "native/base/errors.hpp"
#include "native/hopper/candidate_table.hpp"
#include "native/hopper/energy.hpp"
#include "native/hopper/neighbourhood.hpp"
#include "tests/native/hopper/hoppers.hpp"

#include <bit>

using namespace crossgrain;
using namespace crossgrain::hopper;

namespace {

// Four orders of magnitude apart: the total names its terms.
Energies rules() {
    return {.c_d = 1, .c_o = 1'000, .c_i = 1'000'000, .c_w = 1'000'000'000};
}

// {unused, hole, 2, 3, 4, 5, 6, 7}
constexpr Cell bulk{0, 0, 1, 2, 3, 2, 2, 0};
constexpr Cell right_wall{0, 0, 1, 2, outside, outside, 3, 3};
constexpr Cell left_wall{0, 0, 0, 2, 3, 3, 3, outside};

}  // namespace

BOOST_AUTO_TEST_CASE(each_term_counts_what_the_paper_says) {
    // From 3 (orientation 2), new orientation 2: unlike are 2 (1), 3 (now empty), 4 (3), 7 (empty).
    BOOST_TEST(total_energy(bulk, {3, 2}, rules()) == 4);
    // The same turned to 1: like is 2 alone; one step of rotation.
    BOOST_TEST(total_energy(bulk, {3, 1}, rules()) == 1'000'005);
    // From 4 (orientation 3), moving along itself, turned to 1: two steps, not cyclic.
    BOOST_TEST(total_energy(bulk, {4, 1}, rules()) == 2'000'005);
    // At the right wall from 2 (orientation 1): 4 and 5 are outside and do not count.
    BOOST_TEST(total_energy(right_wall, {2, 3}, rules()) == 2'000'002);
    BOOST_TEST(total_energy(right_wall, {2, 1}, rules()) == 1'000'000'004);
    // At the left wall from 4 (orientation 3), kept: 2 is empty and counts.
    BOOST_TEST(total_energy(left_wall, {4, 3}, rules()) == 1'000'000'003);
    BOOST_TEST(total_energy(left_wall, {3, 1}, rules()) == 1'000'005);
    // A grain of orientation 1 that moves straight down crosses itself by one step.
    BOOST_TEST(orientation_energy({0, 0, 0, 1, 0, 0, 0, 0}, {3, 1}, rules()) == 1'000);
    BOOST_TEST(orientation_energy({0, 0, 3, 0, 0, 0, 0, 0}, {2, 1}, rules()) == 2'000);
}

BOOST_AUTO_TEST_CASE(the_literal_inertia_does_not_depend_on_the_new_orientation) {
    auto c = rules();
    c.inertia = Inertia::literal;
    for (int o = 1; o <= 3; ++o)
        BOOST_TEST(inertia_energy(bulk, {4, o}, c) == 3'000'000);
}

BOOST_AUTO_TEST_CASE(the_best_candidates_are_those_within_the_tolerance) {
    auto c = rules();
    BOOST_TEST(best_candidates(bulk, c) == 1U << number_of({3, 2}));
    // The other two sources, kept as they are, have six unlike neighbours instead of four.
    c.tie_tolerance = 1;
    BOOST_TEST(best_candidates(bulk, c) == 1U << number_of({3, 2}));
    c.tie_tolerance = 2;
    BOOST_TEST(best_candidates(bulk, c) ==
               (1U << number_of({3, 2}) | 1U << number_of({2, 1}) | 1U << number_of({4, 3})));
    BOOST_TEST(std::popcount(all_candidates(bulk, c)) == 9);
    c.rotation = false;
    BOOST_TEST(std::popcount(all_candidates(bulk, c)) == 3);
    BOOST_TEST(best_candidates({0, 0, 0, outside, 0, 1, 1, 1}, c) == 0);
}

BOOST_AUTO_TEST_CASE(coefficients_are_decimal_numbers_not_binary_ones) {
    BOOST_TEST(to_energy(0, "c") == 0);
    BOOST_TEST(to_energy(0.1, "c") == 100'000'000'000);
    BOOST_TEST(to_energy(0.0009, "c") == 900'000'000);
    BOOST_TEST(to_energy(1e-12, "c") == 1);
    BOOST_TEST(to_energy(10, "c") == 10'000'000'000'000);
    BOOST_TEST(to_energy(1e5, "c") == 100'000'000'000'000'000);
    BOOST_TEST(to_energy(0.1, "c") + to_energy(0.2, "c") == to_energy(0.3, "c"));
    for (const double bad : {-1e-3, 1.1e5, 1e-13, 0.1234567890123, std::nan("")}) {
        BOOST_CHECK_THROW((void)to_energy(bad, "c"), CaseError);
    }
}

BOOST_AUTO_TEST_CASE(the_knife_edge_of_the_paper_is_a_tie) {
    // C_O = eps = 0.001: with binary fractions, sums of 0.1 and 0.001 would decide by rounding.
    const auto c =
        integer_energies({.c_d = 0.5, .c_o = 0.001, .c_i = 0.1, .c_w = 10, .tie_tolerance = 0.001});
    // Sources 2 and 3 with orientation 1: straight down costs exactly the tolerance more.
    const Cell cell{0, 0, 1, 1, 0, 1, 1, 1};
    BOOST_TEST(best_candidates(cell, c) == (1U << number_of({2, 1}) | 1U << number_of({3, 1})));
    auto less = c;
    less.tie_tolerance -= 1;
    BOOST_TEST(best_candidates(cell, less) == 1U << number_of({2, 1}));
}

BOOST_AUTO_TEST_CASE(the_table_is_the_energy_rule_for_all_neighbourhoods) {
    const auto c = integer_energies(tests::small_hopper().rules);
    const CandidateTable table(c);
    std::size_t wrong = 0;
    for (std::uint32_t number = 0; number < neighbourhoods; ++number) {
        const Cell cell = neighbourhood(number);
        const std::uint16_t entry = table.entries()[CandidateTable::index(
            cell[2], cell[3], cell[4], cell[5], cell[6], cell[7])];
        wrong += (entry & CandidateTable::candidates) != best_candidates(cell, c);
        const bool below = cell[5] == 0 || cell[6] == 0 || cell[7] == 0;
        wrong += ((entry & CandidateTable::hole_below) != 0) != below;
    }
    BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(a_mask_as_a_list_has_its_candidates_in_order) {
    const auto list = candidate_lists[0b100'010'001];
    BOOST_TEST((list & 15) == 3);
    BOOST_TEST((list >> 4 & 15) == 0 * 4 + 1);   // source 2, orientation 1
    BOOST_TEST((list >> 8 & 15) == 1 * 4 + 2);   // source 3, orientation 2
    BOOST_TEST((list >> 12 & 15) == 2 * 4 + 3);  // source 4, orientation 3
    BOOST_TEST(candidate_lists[0] == 0);
}
