#include "contract/clerk_impl.hpp"

#include <string>

#include "contract/ros_places.hpp"

namespace contract
{

ClerkImpl::ClerkImpl(const ClerkPassthrough & passthrough)
: passthrough_(passthrough),
  behaviour_("clerk", {
      {"publish", [this](const auto & a) {
          clerk_types::PubSay message;
          message.data = a.at(0);
          passthrough_.pub_say->publish(message);
          return std::string("null");
        }},
      {"fail", [this](const auto & a) {
          passthrough_.fail(a.at(0));
          return std::string("null");
        }},
      {"open", [this](const auto & a) {return open(a.at(0));}},
      {"sleep", [this](const auto & a) {return json(passthrough_.sleep(std::stod(a.at(0))));}},
    })
{
}

/// Publish by the client library, on a topic that the spec does not know.
std::string ClerkImpl::open(const std::string & text)
{
  clerk_types::PubSay message;
  message.data = text;
#ifdef ROSCPP_ROS_H
  if (!door_) {
    door_ = passthrough_.node->advertise<clerk_types::PubSay>("door", 1);
  }
  door_.publish(message);
#else
  if (!door_) {
    door_ = rclcpp::create_publisher<clerk_types::PubSay>(*passthrough_.node, "door", 1);
  }
  door_->publish(message);
#endif
  return "null";
}

bool ClerkImpl::configure(const ClerkConfig &)
{
  return behaviour_.run("configure");
}

std::string ClerkImpl::reconfigure(const ClerkConfig & config)
{
  return behaviour_.run("reconfigure", json(config.pace)) ? "" : "told to refuse";
}

bool ClerkImpl::activate()
{
  return behaviour_.run("activate");
}

void ClerkImpl::serve_greet(
  const clerk_types::GreetService::Request &, clerk_types::GreetService::Response & response)
{
  behaviour_.run("serve");
  response.success = true;
  response.message = "greeted";
}

void ClerkImpl::read()
{
  behaviour_.run("read");
  passthrough_.sleep(0.02);
}

void ClerkImpl::poll()
{
  behaviour_.run("poll");
}

void ClerkImpl::deactivate()
{
  behaviour_.run("deactivate");
}

void ClerkImpl::cleanup()
{
  behaviour_.run("cleanup");
}

}  // namespace contract
