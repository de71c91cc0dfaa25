#ifndef CONTRACT__GAUGE_IMPL_HPP_
#define CONTRACT__GAUGE_IMPL_HPP_

#include "contract/behaviour.hpp"
#include "contract/gauge_interface.hpp"

namespace contract
{

/// The logic of gauge: it does what the test tells it; see gauge_impl.py.
class GaugeImpl
{
public:
  explicit GaugeImpl(const GaugePassthrough & passthrough);
  bool configure(const GaugeConfig & config);
  bool activate();
  void update(GaugeData & data, const GaugeConfig & config);
  void deactivate();
  void cleanup();

private:
  Behaviour behaviour_;
};

}  // namespace contract

#endif  // CONTRACT__GAUGE_IMPL_HPP_
