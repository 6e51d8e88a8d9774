#include "native/dem/neighbour_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/dem/neighbour_search.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#ifndef CROSSGRAIN_DEM_SET_BITS_FIRST
#define CROSSGRAIN_DEM_SET_BITS_FIRST
namespace crossgrain::dem {

/// For every eight bits the numbers of those that are set, and zeros behind them.
constexpr auto set_bits_first = [] {
    std::array<std::array<std::int32_t, 8>, 256> table{};
    for (unsigned bits = 0; bits < table.size(); ++bits) {
        std::size_t next = 0;
        for (int bit = 0; bit < 8; ++bit)
            if ((bits >> bit & 1U) != 0) table[bits][next++] = bit;
    }
    return table;
}();

}  // namespace crossgrain::dem
#endif

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<D>;

/// Stores the lanes of a mask one after the other, and anything behind them. Returns their number.
HWY_INLINE std::size_t StoreWhere(hn::Mask<D> where, hn::Vec<DI> v, std::int32_t* HWY_RESTRICT to) {
#if HWY_TARGET <= HWY_AVX3 || HWY_TARGET == HWY_SCALAR
    // Not CompressStore: to memory it takes a hundred cycles on some machines.
    hn::StoreU(hn::Compress(v, hn::RebindMask(DI(), where)), DI(), to);
    return hn::CountTrue(D(), where);
#else
    // Not Compress either, whose table Highway 1.0.3 copies before each use.
    static_assert(hn::MaxLanes(D()) <= set_bits_first[0].size());
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(D(), where, bits);
    const auto lanes = hn::SetTableIndices(DI(), set_bits_first[bits[0]].data());
    hn::StoreU(hn::TableLookupLanes(v, lanes), DI(), to);
    return static_cast<std::size_t>(std::popcount(bits[0]));
#endif
}

/// Writes the neighbours of one grain behind those of the grains before it.
class Search {
  public:
    HWY_INLINE Search(const CellView& cells, std::size_t grain, FoundNeighbours& found,
                      std::size_t first)
        : cells_(cells), numbers_(reinterpret_cast<std::int32_t*>(found.neighbours.data() + first)),
          grain_(hn::Set(DI(), static_cast<std::int32_t>(grain))), lane_(hn::Iota(DI(), 0)),
          y_(hn::Set(D(), cells.y[grain])), range_limit_(hn::Set(D(), cells.range_squared)),
          near_limit_(hn::Set(D(), cells.near_squared)) {}

    /// Candidates first ... end - 1, for a grain at x from the left of their column. Returns
    /// whether one of them was a neighbour.
    HWY_INLINE bool Look(std::size_t first, std::size_t end, float x) {
        const D d;
        const DI di;
        const std::size_t before = count;
        for (std::size_t j = first; j < end; j += hn::Lanes(d)) {
            const auto dx = hn::Sub(hn::Set(d, x), hn::LoadU(d, cells_.x.data() + j));
            const auto dy = hn::Sub(y_, hn::LoadU(d, cells_.y.data() + j));
            const auto r_squared = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
            // Not Iota of j, which some versions put together in memory, number by number.
            const auto numbers = hn::Add(lane_, hn::Set(di, static_cast<std::int32_t>(j)));
            const auto candidate =
                hn::And(hn::Lt(numbers, hn::Set(di, static_cast<std::int32_t>(end))),
                        hn::Ne(numbers, grain_));
            const auto within =
                hn::And(hn::Lt(r_squared, range_limit_), hn::RebindMask(d, candidate));
            count += StoreWhere(within, numbers, numbers_ + count);
            near_count += hn::CountTrue(d, hn::And(within, hn::Lt(r_squared, near_limit_)));
            if (count > FoundNeighbours::most) break;
        }
        return count > before;
    }

    std::size_t count = 0, near_count = 0;

  private:
    const CellView& cells_;
    std::int32_t* HWY_RESTRICT numbers_;
    hn::Vec<DI> grain_, lane_;
    hn::Vec<D> y_, range_limit_, near_limit_;
};

/// Room for all neighbours of one more grain and a whole vector behind the last that is let pass.
void MakeRoom(FoundNeighbours& found, std::size_t behind) {
    const std::size_t needed = behind + FoundNeighbours::most + 64;
    if (found.neighbours.size() >= needed) return;
    found.neighbours.resize(2 * needed);
}

void Find(const CellView& cells, std::size_t first, std::size_t last, FoundNeighbours& found) {
    found.counts.resize(last - first);
    found.crosses.resize(last - first);
    found.near_counts.resize(last - first);
    std::size_t next = 0;
    for (std::size_t i = first; i < last; ++i) {
        MakeRoom(found, next);
        Search search(cells, i, found, next);
        const std::size_t column = cells.cell[i] / cells.rows;
        const std::size_t row = cells.cell[i] - column * cells.rows;
        const std::size_t low = row > 0 ? row - 1 : 0;
        const std::size_t high = std::min(row + 1, cells.rows - 1);
        const auto look = [&](std::size_t in_column, float shift) HWY_ATTR {
            const std::size_t base = in_column * cells.rows;
            return search.Look(cells.start[base + low], cells.start[base + high + 1],
                               cells.x[i] + shift);
        };
        bool crosses = false;
        if (column > 0) {
            look(column - 1, cells.column_width);
        } else if (cells.periodic) {
            crosses = look(cells.columns - 1, cells.column_width);
        }
        look(column, 0);
        if (column + 1 < cells.columns) {
            look(column + 1, -cells.column_width);
        } else if (cells.periodic) {
            crosses = look(0, -cells.column_width) || crosses;
        }
        if (search.count > FoundNeighbours::most) {
            found.crowded = true;
            return;
        }
        found.near_counts[i - first] = static_cast<std::uint32_t>(search.near_count);
        found.counts[i - first] = static_cast<std::uint32_t>(search.count);
        found.crosses[i - first] = crosses ? 1 : 0;
        next += search.count;
    }
}

FindNeighbours TheFunction() {
    return Find;
}

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crossgrain::dem {

HWY_EXPORT(TheFunction);

FindNeighbours find_neighbours_function() {
    return HWY_DYNAMIC_DISPATCH(TheFunction)();
}

}  // namespace crossgrain::dem
#endif
