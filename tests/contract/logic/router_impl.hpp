#ifndef CONTRACT__ROUTER_IMPL_HPP_
#define CONTRACT__ROUTER_IMPL_HPP_

#include <string>

#include "contract/behaviour.hpp"
#include "contract/router_interface.hpp"

namespace contract
{

/// The logic of router: it does what the test tells it; see router_impl.py.
class RouterImpl
{
public:
  explicit RouterImpl(const RouterPassthrough & passthrough);
  bool configure(const RouterConfig & config);
  bool activate();
  void receive_take(const std::string & topic, const router_types::TakeMessage & message);
  void deactivate();
  void cleanup();

private:
  Behaviour behaviour_;
};

}  // namespace contract

#endif  // CONTRACT__ROUTER_IMPL_HPP_
