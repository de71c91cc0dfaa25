#include "contract/gauge_impl.hpp"

#include "contract/ros_places.hpp"

namespace contract
{

GaugeImpl::GaugeImpl(const GaugePassthrough & passthrough)
: behaviour_("gauge", {
      {"fail", [passthrough](const auto & a) {
          passthrough.fail(a.at(0));
          return std::string("null");
        }},
    })
{
}

bool GaugeImpl::configure(const GaugeConfig &)
{
  return behaviour_.run("configure");
}

bool GaugeImpl::activate()
{
  return behaviour_.run("activate");
}

void GaugeImpl::update(GaugeData &, const GaugeConfig & config)
{
  behaviour_.run("update", "{\"gain\": " + json(config.gain) + "}");
}

void GaugeImpl::deactivate()
{
  behaviour_.run("deactivate");
}

void GaugeImpl::cleanup()
{
  behaviour_.run("cleanup");
}

}  // namespace contract
