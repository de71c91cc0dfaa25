#include "contract/gauge_impl.hpp"

#include <string>
#include <thread>

#include "contract/ros_places.hpp"

namespace contract
{

GaugeImpl::GaugeImpl(const GaugePassthrough & passthrough)
: behaviour_("gauge", {
      {"fail", [passthrough](const auto & a) {
          passthrough.fail(a.at(0));
          return std::string("null");
        }},
      {"diagnose", [status = passthrough.diagnostics](const auto & a) {
          const auto number = std::stoi(a.at(2));
          std::thread([status, number] {status->set("number", number);}).join();
          status->set("is_said", true);
          status->set_hardware_id(a.at(1));
          if (a.at(0) == "ok") {
            status->ok(a.at(1));
          } else {
            a.at(0) == "error" ? status->error(a.at(1)) : status->warning(a.at(1));
          }
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
