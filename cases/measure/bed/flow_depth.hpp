// How deep a vibrated bed flows (Taguchi, chao-dyn/9405003 (1994), Fig. 1 and section 2.3: flow is
// the exchange among particles; translation and expansion of the bed are none).
//
// Once per period of the bottom, bonds are drawn between grains nearer than 1.25 d, and a bond is
// lost if its ends are more than 1.5 d apart one period later (the second shell of a triangular
// lattice is at 1.73 d). Grains are ordered by height and cut into layers of L = L_h/d grains, the
// last one the surface. A layer flows if more than `share` of the bonds of its grains are lost per
// period, averaged over the run; the flow depth is the number of flowing layers times the height of
// a row, sqrt(3)/2 d.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/scene/contact_search.hpp"

#include <optional>
#include <vector>

namespace crossgrain::measure {

struct FlowDepthOptions {
    double skip = 0;
    double share = 0.01;
};

inline OptionKeys option_keys(FlowDepthOptions& o) {
    return {{"skip", &o.skip, Range::not_negative(),
             "periods that begin before this time (t) do not count"},
            {"share", &o.share, Range::open(0, 1), "of the bonds lost per period"}};
}

/// Measurements: `flow_depth` (l), standard error by the jackknife over six batches of periods,
/// systematic error half the spread between half and twice the share; `flowing_layers`, the same in
/// rows; `lost_bonds`, the share of all bonds that is lost per period, with its blocked error; n is
/// the number of periods. Series "flow-profile": layer (1 at the bottom), lost_bonds.
///
/// Nothing with fewer than twelve periods, or for scenes without a moving bottom or a period along
/// x. Throws std::invalid_argument for an option out of range.
class FlowDepth final : public Estimator {
  public:
    using Options = FlowDepthOptions;
    FlowDepth(const scene::Scene& scene, FlowDepthOptions options);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    struct Bond {
        std::size_t i = 0, j = 0;
    };
    /// Bonds of a layer's grains, and those of them that were lost; a bond between two layers
    /// counts in both. Shape (layers).
    struct Exchange {
        std::vector<double> bonds, lost;
    };

    void begin_period(const scene::Frame& frame);
    void end_period(const scene::Frame& frame);
    [[nodiscard]] std::vector<double> lost_shares(std::size_t skip_from, std::size_t skip_to) const;
    [[nodiscard]] static double flowing_layers(const std::vector<double>& shares, double share);

    FlowDepthOptions options_;
    std::optional<double> period_;  ///< absent if the scene cannot be measured
    std::optional<double> period_x_, period_y_;
    double diameter_ = 0;
    double interval_ = 0;  ///< between frames (t)
    std::size_t layer_size_ = 1;
    scene::ContactSearch search_;
    double next_ = 0;  ///< when the present period ends (t)
    std::vector<Bond> bonds_;
    std::vector<std::size_t> layer_;   ///< shape (grains), at the start of the period
    std::vector<Exchange> exchanges_;  ///< shape (periods)
};

}  // namespace crossgrain::measure
