#include "native/lga/bins.hpp"
#include "native/lga/ensemble.hpp"
#include "native/lga/table_replica.hpp"

#include <utility>

namespace crossgrain::lga {
namespace {

class TableEnsemble final : public Ensemble {
  public:
    explicit TableEnsemble(const Model& model) : geometry_(model) {
        for (int r = 0; r < model.replicas; ++r)
            replicas_.emplace_back(model, r);
    }

    void advance(std::int64_t steps) override {
        for (; steps > 0 && saturated_.empty(); --steps) {
            bool any = false;
            for (auto& replica : replicas_) {
                replica.advance();
                any = any || replica.saturated();
            }
            ++step_;
            if (!any) continue;
            for (const auto& replica : replicas_)
                saturated_.push_back(replica.saturated() ? 1 : 0);
        }
    }
    [[nodiscard]] std::int64_t step() const override { return step_; }
    [[nodiscard]] const std::vector<std::uint8_t>& saturated() const override { return saturated_; }
    void measure(int bin, const Fields& fields, BinValues& values) const override;
    [[nodiscard]] std::uint8_t site(int replica, Site site) const override {
        return replicas_[static_cast<std::size_t>(replica)]
            .sites()[static_cast<std::size_t>(geometry_.index(site))];
    }
    [[nodiscard]] bool is_compiled() const override { return false; }

  private:
    Geometry geometry_;
    std::vector<TableReplica> replicas_;
    std::vector<std::uint8_t> saturated_;
    std::int64_t step_ = 0;
};

void TableEnsemble::measure(int bin, const Fields& fields, BinValues& values) const {
    clear(values, fields, geometry_.rows() / bin, static_cast<int>(replicas_.size()));
    for (std::size_t r = 0; r < replicas_.size(); ++r) {
        for (int i = 0; i < geometry_.sites(); ++i) {
            const auto state = replicas_[r].sites()[static_cast<std::size_t>(i)];
            const int excess = replicas_[r].excess()[static_cast<std::size_t>(i)];
            const SiteState site{.movers = static_cast<std::uint8_t>(state & 63U),
                                 .rests = static_cast<std::uint8_t>(state >> rest_bit)};
            if (mass(site) + excess == 0) continue;
            const auto at =
                static_cast<std::size_t>(i % geometry_.rows() / bin) * replicas_.size() + r;
            if (fields.count) {
                values.count[at] =
                    static_cast<std::uint16_t>(values.count[at] + mass(site) + excess);
            }
            if (fields.rests) {
                values.rests[at] =
                    static_cast<std::uint16_t>(values.rests[at] + site.rests + excess);
            }
            if (fields.momentum) {
                values.momentum[at] =
                    static_cast<std::int16_t>(values.momentum[at] + momentum(site.movers).down);
            }
        }
    }
}

}  // namespace

std::unique_ptr<Ensemble> make_table_ensemble(const Model& model) {
    return std::make_unique<TableEnsemble>(model);
}

}  // namespace crossgrain::lga
