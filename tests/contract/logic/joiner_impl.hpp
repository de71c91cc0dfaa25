#ifndef CONTRACT__JOINER_IMPL_HPP_
#define CONTRACT__JOINER_IMPL_HPP_

#include "contract/behaviour.hpp"
#include "contract/joiner_interface.hpp"

namespace contract
{

/// The logic of joiner: it does what the test tells it; see joiner_impl.py.
class JoinerImpl
{
public:
  explicit JoinerImpl(const JoinerPassthrough & passthrough);
  bool configure(const JoinerConfig & config);
  bool activate();
  void receive_exact(const joiner_types::ExactMessages & messages);
  void receive_near(const joiner_types::NearMessages & messages);
  void deactivate();
  void cleanup();

private:
  Behaviour behaviour_;
};

}  // namespace contract

#endif  // CONTRACT__JOINER_IMPL_HPP_
