#include "adapters/run/monitor.hpp"

namespace crossgrain::run {
namespace {

class Silence final : public Progress {
  public:
    void advanced(const std::string& /*run*/, double /*seconds*/, double /*fraction*/) override {}
    void finished(const std::string& /*run*/, double /*seconds*/,
                  const std::string& /*how*/) override {}
};

class SilentMonitor final : public Monitor {
  public:
    void note(const std::string& /*line*/) override {}
    void remark(const std::string& /*line*/) override {}
    std::unique_ptr<Progress> begin(std::size_t /*runs*/, double /*total_seconds*/,
                                    unsigned /*workers*/) override {
        return std::make_unique<Silence>();
    }
};

}  // namespace

Monitor& silent_monitor() {
    static SilentMonitor monitor;
    return monitor;
}

}  // namespace crossgrain::run
