#include "contract/guard_impl.hpp"

#include <string>

#include "contract/ros_places.hpp"

namespace contract
{

GuardImpl::GuardImpl(const GuardPassthrough & passthrough)
: behaviour_("guard", {
      {"fail", [fail = passthrough.fail](const auto & a) {
          fail(a.at(0));
          return std::string("null");
        }},
      {"sleep", [sleep = passthrough.sleep](const auto & a) {
          return json(sleep(std::stod(a.at(0))));
        }},
    })
{
}

bool GuardImpl::configure(const GuardConfig &)
{
  return behaviour_.run("configure");
}

bool GuardImpl::activate()
{
  return behaviour_.run("activate");
}

void GuardImpl::update(GuardData & data, const GuardConfig &)
{
  if (data.in_speed_updated) {
    behaviour_.run("update", json(static_cast<double>(data.in_speed.data)));
  }
}

void GuardImpl::late_speed()
{
  behaviour_.run("late_speed");
}

void GuardImpl::receive_order(const guard_types::OrderMessage & message)
{
  behaviour_.run("order", json(message.data));
}

void GuardImpl::late_order()
{
  behaviour_.run("late_order");
}

void GuardImpl::deactivate()
{
  behaviour_.run("deactivate");
}

void GuardImpl::cleanup()
{
  behaviour_.run("cleanup");
}

}  // namespace contract
