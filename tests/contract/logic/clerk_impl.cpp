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
      {"sleep", [this](const auto & a) {return json(passthrough_.sleep(std::stod(a.at(0))));}},
    })
{
}

bool ClerkImpl::configure(const ClerkConfig &)
{
  return behaviour_.run("configure");
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

void ClerkImpl::deactivate()
{
  behaviour_.run("deactivate");
}

void ClerkImpl::cleanup()
{
  behaviour_.run("cleanup");
}

}  // namespace contract
