#include "contract/router_impl.hpp"

#include <string>
#include <vector>

#include "contract/ros_places.hpp"

namespace contract
{

RouterImpl::RouterImpl(const RouterPassthrough & passthrough)
: behaviour_("router", {
      {"give", [publishers = passthrough.pub_give](const auto & a) {
          router_types::PubGive message;
          message.data = a.at(1);
          publishers.at(a.at(0))->publish(message);
          return std::string("null");
        }},
      {"topics", [publishers = passthrough.pub_give](const auto &) {
          std::vector<std::string> topics;
          for (const auto & [topic, publisher] : publishers) {
            topics.push_back(topic);
          }
          return json(topics);
        }},
    })
{
}

bool RouterImpl::configure(const RouterConfig & config)
{
  return behaviour_.run("configure", json(config.take_topics));
}

bool RouterImpl::activate()
{
  return behaviour_.run("activate");
}

void RouterImpl::receive_take(const std::string & topic, const router_types::TakeMessage & message)
{
  behaviour_.run("take", json(std::vector<std::string>{topic, message.data}));
}

void RouterImpl::deactivate()
{
  behaviour_.run("deactivate");
}

void RouterImpl::cleanup()
{
  behaviour_.run("cleanup");
}

}  // namespace contract
