// Comparing ensembles site by site.
#pragma once

#include "native/lga/ensemble.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::tests {

/// Packed sites of one replica, shape (columns, rows).
inline std::vector<std::uint8_t> sites(const lga::Ensemble& ensemble, const lga::Model& model,
                                       int replica) {
    const lga::Geometry geometry(model);
    std::vector<std::uint8_t> all;
    for (int column = 0; column < geometry.columns(); ++column) {
        for (int row = 0; row < geometry.rows(); ++row) {
            all.push_back(ensemble.site(replica, {.column = column, .row = row}));
        }
    }
    return all;
}

/// The first replica in which the two differ, or -1.
inline int first_difference(const lga::Ensemble& a, const lga::Ensemble& b,
                            const lga::Model& model) {
    for (int r = 0; r < model.replicas; ++r) {
        if (sites(a, model, r) != sites(b, model, r)) return r;
    }
    return -1;
}

}  // namespace crossgrain::tests
