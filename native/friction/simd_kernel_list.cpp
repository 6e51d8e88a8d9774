// What the vectorised kernel does once per neighbour list.
#include "native/friction/simd_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossgrain::friction {
namespace {

/// What a list is meant to last at first, in the time that a grain of root-mean-square speed takes
/// for a radius.
constexpr double first_list_time = 0.4;
/// Margins beyond what a grain travels at its present speed: for what speeds it up.
constexpr double margin_in_mean_speeds = 0.25, margin_in_radii = 0.01;
/// Pairs nearer than this many contact distances go first: they touch, or will.
constexpr double near_pair = 1.002;

}  // namespace

/// Into the period; what unwraps a position stands beside it.
void SimdKernel::wrap() {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto& period = axis == 0 ? p_.period_x : p_.period_y;
        if (!period) continue;
        for (std::size_t k = 0; k < places_; ++k) {
            double* position = &now_.position[4 * k];
            const double shift = *period * std::floor(position[axis] / *period);
            position[axis] -= shift;
            position[axis + 2] += shift;
        }
    }
}

void SimdKernel::set_margins() {
    double squares = 0;
    for (std::size_t k = 0; k < mobile_; ++k) {
        const double* v = &now_.velocity[4 * k];
        squares += v[0] * v[0] + v[1] * v[1];
    }
    const double speed =
        std::sqrt(squares / static_cast<double>(std::max<std::size_t>(mobile_, 1)));
    if (tuning_.time() == 0) {
        // Grains at rest that fall a radius, if nothing else is known.
        const double known =
            std::max(speed, std::sqrt(p_.gravity * largest_radius_) + 1e-3 * largest_radius_);
        tuning_ = ListTuning(first_list_time * largest_radius_ / known);
    }
    const double least =
        margin_in_radii * largest_radius_ + margin_in_mean_speeds * speed * tuning_.time();
    const auto margin = [&](double v) {
        // In this order a margin that is no number becomes the widest one: the search will tell.
        return std::min(widest_margin_, least + std::abs(v) * tuning_.time());
    };
    margin_x_.resize(mobile_);
    margin_y_.resize(mobile_);
    for (std::size_t k = 0; k < mobile_; ++k) {
        margin_x_[k] = margin(now_.velocity[4 * k]);
        margin_y_[k] = margin(now_.velocity[4 * k + 1]);
    }
}

/// Of pair k of the list, as a vector in the tangent of the present positions.
ContactMemory SimdKernel::memory_of(std::size_t k) const {
    const auto& m = pairs_.memory;
    if (memories_ == 4) return {.x = m[0][k], .y = m[1][k], .nx = m[2][k], .ny = m[3][k]};
    if (memories_ == 2) return {.x = m[0][k], .y = m[1][k]};
    const double* xi = &now_.position[pairs_.i[k]];
    const double* xj = &now_.position[pairs_.j[k]];
    const double dx = xi[0] - xj[0] + pairs_.shift_x[k], dy = xi[1] - xj[1] + pairs_.shift_y[k];
    const double r = std::sqrt(dx * dx + dy * dy);
    return {.x = -m[0][k] * dy / r, .y = m[0][k] * dx / r};
}

void SimdKernel::remember(std::size_t k, const ContactMemory& memory) {
    auto& m = pairs_.memory;
    if (memories_ == 1) {
        const double* xi = &now_.position[pairs_.i[k]];
        const double* xj = &now_.position[pairs_.j[k]];
        const double dx = xi[0] - xj[0] + pairs_.shift_x[k];
        const double dy = xi[1] - xj[1] + pairs_.shift_y[k];
        m[0][k] = (memory.y * dx - memory.x * dy) / std::sqrt(dx * dx + dy * dy);
    } else {
        const double values[] = {memory.x, memory.y, memory.nx, memory.ny};
        for (std::size_t a = 0; a < memories_; ++a)
            m[a][k] = values[a];
    }
    pairs_.remembers[k / 4] = 1;
    // Of a vector of 8 pairs the first flag counts.
    pairs_.remembers[k / batch * 2] = 1;
}

void SimdKernel::keep_contacts() {
    carrier_.clear();
    for (std::size_t k = 0; memories_ > 0 && k < pairs_.i.size(); ++k) {
        if (k % batch == 0 && !pairs_.remembers[k / 4] && !pairs_.remembers[k / 4 + 1]) {
            k += batch - 1;
            continue;
        }
        const bool empty = pairs_.memory[0][k] == 0 && (memories_ == 1 || pairs_.memory[1][k] == 0);
        if (empty && (memories_ < 4 || (pairs_.memory[2][k] == 0 && pairs_.memory[3][k] == 0)))
            continue;
        carrier_.keep(now_.grain[pairs_.i[k] / 4], now_.grain[pairs_.j[k] / 4], memory_of(k));
    }
}

void SimdKernel::find_pairs() {
    x_.clear();
    y_.clear();
    radius_.clear();
    for (std::size_t k = 0; k < places_; ++k) {
        if (now_.grain[k] == no_grain) continue;
        x_.push_back(now_.position[4 * k]);
        y_.push_back(now_.position[4 * k + 1]);
        radius_.push_back(now_.radius[k]);
    }
    search_.find({.x = x_,
                  .y = y_,
                  .radius = radius_,
                  .margin_x = margin_x_,
                  .margin_y = margin_y_,
                  .mobile = mobile_});
}

/// Neighbours next to each other in memory.
void SimdKernel::reorder() {
    const auto& order = search_.order();
    for (std::uint32_t searched = 0; searched < order.size(); ++searched) {
        const std::size_t to = place_of(searched), from = place_of(order[searched]);
        std::copy_n(&now_.position[4 * from], 4, &sorted_.position[4 * to]);
        std::copy_n(&now_.velocity[4 * from], 4, &sorted_.velocity[4 * to]);
        std::copy_n(&now_.own[4 * from], 4, &sorted_.own[4 * to]);
        std::copy_n(&now_.torque[4 * from], 4, &sorted_.torque[4 * to]);
        sorted_.radius[to] = now_.radius[from];
        sorted_.mass[to] = now_.mass[from];
        sorted_.grain[to] = now_.grain[from];
        if (searched >= mobile_) continue;
        margin_[4 * to] = margin_x_[order[searched]];
        margin_[4 * to + 1] = margin_y_[order[searched]];
    }
    std::swap(now_, sorted_);
    // What gravity has done to the padding.
    for (const std::size_t k : {mobile_, places_ - 1}) {
        if (now_.grain[k] != no_grain) continue;
        std::fill_n(&now_.position[4 * k], 4, 0.0);
        std::fill_n(&now_.velocity[4 * k], 4, 0.0);
    }
    for (std::size_t k = 0; k < 4 * (mobile_ + padding_); ++k)
        listed_[k] = now_.position[k];
}

void SimdKernel::append(const NearPair& pair, bool near) {
    const std::uint32_t i = place_of(pair.i), j = place_of(pair.j);
    pairs_.i.push_back(4 * i);
    pairs_.j.push_back(4 * j);
    pairs_.shift_x.push_back(pair.shift_x);
    pairs_.shift_y.push_back(pair.shift_y);
    pairs_.reach.push_back(now_.radius[i] + now_.radius[j]);
    if (p_.contact.damping_scale == DampingScale::effective_mass) {
        const double mi = now_.mass[i], mj = now_.mass[j];
        const double effective = j < mobile_ ? mi * mj / (mi + mj) : mi;
        pairs_.damping.push_back(p_.contact.damping * effective);
        pairs_.tangential_damping.push_back(p_.contact.tangential_damping * effective);
    }
    if (!near || memories_ == 0) return;
    const auto memory = carrier_.find(now_.grain[i], now_.grain[j]);
    if (memory.x == 0 && memory.y == 0 && memory.nx == 0 && memory.ny == 0) return;
    const std::size_t k = pairs_.i.size() - 1;
    remember(k, memory);
}

/// To whole batches, with pairs of the place that touches nobody.
void SimdKernel::pad_list() {
    const auto nobody = static_cast<std::uint32_t>(4 * (places_ - 1));
    while (pairs_.i.size() % batch != 0) {
        pairs_.i.push_back(nobody);
        pairs_.j.push_back(nobody);
        for (auto* values : {&pairs_.shift_x, &pairs_.shift_y, &pairs_.reach})
            values->push_back(0);
        if (p_.contact.damping_scale == DampingScale::absolute) continue;
        pairs_.damping.push_back(0);
        pairs_.tangential_damping.push_back(0);
    }
}

void SimdKernel::fill_list() {
    const auto& table = search_.pairs();
    for (auto* values : {&pairs_.shift_x, &pairs_.shift_y, &pairs_.reach, &pairs_.damping,
                         &pairs_.tangential_damping})
        values->clear();
    pairs_.i.clear();
    pairs_.j.clear();
    const std::size_t room = table.size() + 2 * batch;
    for (std::size_t a = 0; a < memories_; ++a)
        pairs_.memory[a].assign(room / batch * batch, 0.0);
    pairs_.remembers.assign(room / 4 + 1, 0);
    far_.clear();
    for (const NearPair& pair : table) {
        const std::size_t i = place_of(pair.i), j = place_of(pair.j);
        const double dx = now_.position[4 * i] - now_.position[4 * j] + pair.shift_x;
        const double dy = now_.position[4 * i + 1] - now_.position[4 * j + 1] + pair.shift_y;
        const double reach = near_pair * (now_.radius[i] + now_.radius[j]);
        if (dx * dx + dy * dy < reach * reach) {
            append(pair, true);
        } else {
            far_.push_back(pair);
        }
    }
    pad_list();
    for (const NearPair& pair : far_)
        append(pair, false);
    pad_list();
}

void SimdKernel::list_pairs() {
    if (builds_ > 0) {
        const auto grains = static_cast<double>(std::max<std::size_t>(mobile_, 1));
        tuning_.list_has_lasted(s_.step - listed_at_, static_cast<double>(pairs_.i.size()) / grains,
                                static_cast<double>(pairs_.worked_out) / grains);
        pairs_.worked_out = 0;
    }
    keep_contacts();
    wrap();
    set_margins();
    find_pairs();
    reorder();
    fill_list();
    listed_at_ = s_.step;
    left_margin_ = false;
    ++builds_;
}

}  // namespace crossgrain::friction
