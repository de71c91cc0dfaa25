#ifndef CONTRACT__CLERK_IMPL_HPP_
#define CONTRACT__CLERK_IMPL_HPP_

#include <string>

#include "contract/behaviour.hpp"
#include "contract/clerk_interface.hpp"

namespace contract
{

/// The logic of clerk: it does what the test tells it; see clerk_impl.py.
class ClerkImpl
{
public:
  explicit ClerkImpl(const ClerkPassthrough & passthrough);
  bool configure(const ClerkConfig & config);
  std::string reconfigure(const ClerkConfig & config);
  bool activate();
  void serve_greet(
    const clerk_types::GreetService::Request & request,
    clerk_types::GreetService::Response & response);
  void read();
  void poll();
  void deactivate();
  void cleanup();

private:
  std::string open(const std::string & text);

  ClerkPassthrough passthrough_;
#ifdef ROSCPP_ROS_H
  ros::Publisher door_;
#else
  rclcpp::Publisher<clerk_types::PubSay>::SharedPtr door_;
#endif
  Behaviour behaviour_;
};

}  // namespace contract

#endif  // CONTRACT__CLERK_IMPL_HPP_
