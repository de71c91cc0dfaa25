#include "contract/joiner_impl.hpp"

#include <string>

#include "contract/ros_places.hpp"

namespace contract
{

JoinerImpl::JoinerImpl(const JoinerPassthrough & passthrough)
: behaviour_("joiner", {
      {"fail", [fail = passthrough.fail](const auto & a) {
          fail(a.at(0));
          return std::string("null");
        }},
    })
{
}

bool JoinerImpl::configure(const JoinerConfig &)
{
  return behaviour_.run("configure");
}

bool JoinerImpl::activate()
{
  return behaviour_.run("activate");
}

void JoinerImpl::receive_exact(const joiner_types::ExactMessages & messages)
{
  behaviour_.run(
    "exact",
    "[" + json(messages.left.point.x) + ", " + json(messages.right.point.x) + "]");
}

void JoinerImpl::receive_near(const joiner_types::NearMessages & messages)
{
  behaviour_.run(
    "near",
    "[" + json(messages.left.point.x) + ", " + json(messages.other.point.x) + ", " +
    json(messages.third.point.x) + "]");
}

void JoinerImpl::deactivate()
{
  behaviour_.run("deactivate");
}

void JoinerImpl::cleanup()
{
  behaviour_.run("cleanup");
}

}  // namespace contract
