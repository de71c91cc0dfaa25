#include "contract/dial_impl.hpp"

#include <string>

#include "contract/ros_places.hpp"

namespace contract
{

namespace
{

/// The parameters as JSON.
std::string seen(const DialConfig & config)
{
  return "{\"device\": " + json(config.device) + ", \"speed\": " + json(config.speed) +
         ", \"axis_linear_x\": " + std::to_string(config.axis_linear_x) +
         ", \"turns\": " + std::to_string(config.turns) + ", \"mode\": " + json(config.mode) +
         ", \"sizes\": " + json(config.sizes) + ", \"flags\": " + json(config.flags) + "}";
}

}  // namespace

DialImpl::DialImpl(const DialPassthrough &)
: behaviour_("dial", {})
{
}

bool DialImpl::configure(const DialConfig & config)
{
  return behaviour_.run("configure", seen(config));
}

bool DialImpl::activate()
{
  return behaviour_.run("activate");
}

void DialImpl::deactivate()
{
  behaviour_.run("deactivate");
}

void DialImpl::cleanup()
{
  behaviour_.run("cleanup");
}

}  // namespace contract
