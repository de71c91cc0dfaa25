#ifndef CONTRACT__DIAL_IMPL_HPP_
#define CONTRACT__DIAL_IMPL_HPP_

#include "contract/behaviour.hpp"
#include "contract/dial_interface.hpp"

namespace contract
{

/// The logic of dial: it does what the test tells it; see dial_impl.py.
class DialImpl
{
public:
  explicit DialImpl(const DialPassthrough & passthrough);
  bool configure(const DialConfig & config);
  bool activate();
  void deactivate();
  void cleanup();

private:
  Behaviour behaviour_;
};

}  // namespace contract

#endif  // CONTRACT__DIAL_IMPL_HPP_
