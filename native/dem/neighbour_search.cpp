#include "native/dem/neighbour_search.hpp"

#include <algorithm>
#include <array>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/dem/neighbour_search.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using DI = hn::RebindToUnsigned<D>;

/// The neighbours of one grain, those that are likely to touch soon before the others.
class Search {
  public:
    HWY_INLINE Search(const CellView& cells, std::size_t grain)
        : cells_(cells), grain_(hn::Set(DI(), static_cast<std::uint32_t>(grain))),
          y_(hn::Set(D(), cells.y[grain])), near_limit_(hn::Set(D(), cells.near_squared)),
          range_limit_(hn::Set(D(), cells.range_squared)) {}

    /// Candidates first ... end - 1, for a grain at x from the left of their column. Returns
    /// whether one of them was a neighbour.
    HWY_INLINE bool Look(std::size_t first, std::size_t end, float x) {
        const D d;
        const DI di;
        const std::size_t before = near_count + far_count;
        for (std::size_t j = first; j < end; j += hn::Lanes(d)) {
            const auto dx = hn::Sub(hn::Set(d, x), hn::LoadU(d, cells_.x.data() + j));
            const auto dy = hn::Sub(y_, hn::LoadU(d, cells_.y.data() + j));
            const auto r_squared = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
            const auto numbers = hn::Iota(di, static_cast<std::uint32_t>(j));
            const auto within = hn::And(hn::FirstN(d, end - j),
                                        hn::And(hn::Lt(r_squared, range_limit_),
                                                hn::RebindMask(d, hn::Ne(numbers, grain_))));
            const auto is_near = hn::And(within, hn::Lt(r_squared, near_limit_));
            const auto is_far = hn::AndNot(is_near, within);
            // Not CompressStore: to memory it takes a hundred cycles on some machines.
            hn::StoreU(hn::Compress(numbers, hn::RebindMask(di, is_near)), di,
                       near.data() + near_count);
            hn::StoreU(hn::Compress(numbers, hn::RebindMask(di, is_far)), di,
                       far.data() + far_count);
            near_count += hn::CountTrue(d, is_near);
            far_count += hn::CountTrue(d, is_far);
            if (near_count + far_count > FoundNeighbours::most) break;
        }
        return near_count + far_count > before;
    }

    // Room for a whole vector after the last one that is let pass.
    std::array<std::uint32_t, FoundNeighbours::most + 64> near, far;
    std::size_t near_count = 0, far_count = 0;

  private:
    const CellView& cells_;
    hn::Vec<DI> grain_;
    hn::Vec<D> y_, near_limit_, range_limit_;
};

void Find(const CellView& cells, std::size_t first, std::size_t last, FoundNeighbours& found) {
    found.neighbours.clear();
    found.counts.clear();
    found.crosses.clear();
    for (std::size_t i = first; i < last; ++i) {
        Search search(cells, i);
        const std::size_t column = cells.cell[i] / cells.rows;
        const std::size_t row = cells.cell[i] % cells.rows;
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
        const std::size_t count = search.near_count + search.far_count;
        if (count > FoundNeighbours::most) {
            found.crowded = true;
            return;
        }
        const auto end_of = [](auto& values, std::size_t n) {
            return values.begin() + static_cast<std::ptrdiff_t>(n);
        };
        found.neighbours.insert(found.neighbours.end(), search.near.begin(),
                                end_of(search.near, search.near_count));
        found.neighbours.insert(found.neighbours.end(), search.far.begin(),
                                end_of(search.far, search.far_count));
        found.counts.push_back(static_cast<std::uint32_t>(count));
        found.crosses.push_back(crosses ? 1 : 0);
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
