#ifndef CONTRACT__GUARD_IMPL_HPP_
#define CONTRACT__GUARD_IMPL_HPP_

#include "contract/behaviour.hpp"
#include "contract/guard_interface.hpp"

namespace contract
{

/// The logic of guard: it does what the test tells it; see guard_impl.py.
class GuardImpl
{
public:
  explicit GuardImpl(const GuardPassthrough & passthrough);
  bool configure(const GuardConfig & config);
  bool activate();
  void update(GuardData & data, const GuardConfig & config);
  void late_speed();
  void receive_order(const guard_types::OrderMessage & message);
  void late_order();
  void deactivate();
  void cleanup();

private:
  Behaviour behaviour_;
};

}  // namespace contract

#endif  // CONTRACT__GUARD_IMPL_HPP_
