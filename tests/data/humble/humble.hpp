// What packages use of rclcpp, rclcpp_lifecycle and messages, declared as in Humble (rclcpp 16).
// Where later versions have more, as const methods or rclcpp::QoS of services, this has not.
// Nothing is linked: bodies are there only where a template takes a lambda (decision 77).

#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

#define RCLCPP_ERROR(logger, ...) static_cast<void>(logger)
#define RCLCPP_WARN(logger, ...) static_cast<void>(logger)

enum RCUTILS_LOG_SEVERITY
{
  RCUTILS_LOG_SEVERITY_DEBUG = 10,
  RCUTILS_LOG_SEVERITY_INFO = 20,
  RCUTILS_LOG_SEVERITY_WARN = 30,
  RCUTILS_LOG_SEVERITY_ERROR = 40
};
struct rcutils_log_location_t {const char * function_name, * file_name; std::size_t line_number;};
void rcutils_log(
  const rcutils_log_location_t * location, int severity, const char * name,
  const char * format, ...);

struct rcl_time_jump_t {};
struct rcl_jump_threshold_t
{
  bool on_clock_change;
  struct {std::int64_t nanoseconds;} min_forward, min_backward;
};

struct rmw_qos_profile_t {};
extern const rmw_qos_profile_t rmw_qos_profile_services_default;
struct rmw_request_id_t {};

namespace lifecycle_msgs::msg
{
struct State
{
  enum : std::uint8_t
  {
    PRIMARY_STATE_UNCONFIGURED = 1,
    PRIMARY_STATE_INACTIVE = 2,
    PRIMARY_STATE_ACTIVE = 3,
    PRIMARY_STATE_FINALIZED = 4,
    TRANSITION_STATE_CONFIGURING = 10
  };
};
}  // namespace lifecycle_msgs::msg

namespace rcl_interfaces::msg
{
struct FloatingPointRange {double from_value, to_value;};
struct IntegerRange {std::int64_t from_value, to_value; std::uint64_t step;};
struct ParameterDescriptor
{
  std::string description;
  bool read_only;
  std::vector<FloatingPointRange> floating_point_range;
  std::vector<IntegerRange> integer_range;
};
struct SetParametersResult {bool successful; std::string reason;};
}  // namespace rcl_interfaces::msg

namespace diagnostic_msgs::msg
{
struct KeyValue {std::string key, value;};
struct DiagnosticStatus
{
  enum : std::uint8_t {OK, WARN, ERROR};
  std::uint8_t level;
  std::string name, message, hardware_id;
  std::vector<KeyValue> values;
};
struct Time {};
struct DiagnosticArray
{
  struct {Time stamp;} header;
  std::vector<DiagnosticStatus> status;
};
}  // namespace diagnostic_msgs::msg

namespace rclcpp
{
class Logger
{
public:
  const char * get_name() const;
};
Logger get_logger(const std::string & name);
class NodeOptions {};
class Duration
{
public:
  static Duration from_seconds(double seconds);
  static Duration from_nanoseconds(std::int64_t nanoseconds);
  std::int64_t nanoseconds() const;
  template<typename Chrono>
  Chrono to_chrono() const {return {};}
};
class Time
{
public:
  operator diagnostic_msgs::msg::Time() const;
  Time & operator+=(const Duration & duration);
  Time operator+(const Duration & duration) const;
  Duration operator-(const Time & time) const;
  bool operator<(const Time & time) const;
  bool operator>=(const Time & time) const;
  std::int64_t nanoseconds() const;
};
struct JumpHandler {using SharedPtr = std::shared_ptr<JumpHandler>;};
class Clock
{
public:
  using SharedPtr = std::shared_ptr<Clock>;
  Time now() const;
  bool ros_time_is_active();
  JumpHandler::SharedPtr create_jump_callback(
    std::function<void()> before, std::function<void(const rcl_time_jump_t &)> after,
    const rcl_jump_threshold_t & threshold);
};

class PreShutdownCallbackHandle {};
class Context
{
public:
  using SharedPtr = std::shared_ptr<Context>;
  bool is_valid() const;
  bool shutdown(const std::string & reason);
  PreShutdownCallbackHandle add_pre_shutdown_callback(std::function<void()> callback);
  bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle);
};
class InitOptions {};
enum class SignalHandlerOptions {All, SigInt, SigTerm, None};
void init(
  int argc, char const * const * argv, const InitOptions & init_options = InitOptions(),
  SignalHandlerOptions signal_handler_options = SignalHandlerOptions::All);
bool ok();
bool shutdown(
  Context::SharedPtr context = nullptr,
  const std::string & reason = "user called rclcpp::shutdown()");

class QoS
{
public:
  const rmw_qos_profile_t & get_rmw_qos_profile() const;
};
class ServicesQoS : public QoS {};

enum class CallbackGroupType {MutuallyExclusive, Reentrant};
struct CallbackGroup
{
  using SharedPtr = std::shared_ptr<CallbackGroup>;
  void trigger_notify_guard_condition();
};

namespace node_interfaces
{
class NodeBaseInterface
{
public:
  using SharedPtr = std::shared_ptr<NodeBaseInterface>;
  const char * get_fully_qualified_name() const;
  Context::SharedPtr get_context();
};
}  // namespace node_interfaces

struct ExecutorOptions {Context::SharedPtr context;};
namespace executors
{
class SingleThreadedExecutor
{
public:
  explicit SingleThreadedExecutor(const ExecutorOptions & options = ExecutorOptions());
  void add_callback_group(
    CallbackGroup::SharedPtr group, node_interfaces::NodeBaseInterface::SharedPtr node,
    bool notify = true);
  void add_node(node_interfaces::NodeBaseInterface::SharedPtr node, bool notify = true);
  void remove_node(node_interfaces::NodeBaseInterface::SharedPtr node, bool notify = true);
  void spin();
  void cancel();
};
}  // namespace executors

enum ParameterType : std::uint8_t {PARAMETER_NOT_SET, PARAMETER_BOOL, PARAMETER_INTEGER, PARAMETER_DOUBLE};
class Parameter
{
public:
  ParameterType get_type() const;
  const std::string & get_name() const;
  bool as_bool() const;
  double as_double() const;
};

struct TimerBase
{
  using SharedPtr = std::shared_ptr<TimerBase>;
  void cancel();
};

template<typename Type>
struct Service
{
  void send_response(rmw_request_id_t & id, typename Type::Response & response);
};

template<typename Type>
class Client
{
public:
  using SharedFuture = std::shared_future<std::shared_ptr<typename Type::Response>>;
  struct SharedFutureAndRequestId {std::int64_t request_id;};
  bool service_is_ready() const;
  template<typename Callback>
  SharedFutureAndRequestId async_send_request(
    std::shared_ptr<typename Type::Request>, Callback &&) {return {};}
  bool remove_pending_request(std::int64_t request_id);
};

template<typename Message>
struct Publisher
{
  void publish(const Message & message);
  template<typename Rep, typename Period>
  bool wait_for_all_acked(std::chrono::duration<Rep, Period> timeout) const;
};
template<typename Message, typename Node>
std::shared_ptr<Publisher<Message>> create_publisher(Node & node, const std::string &, int depth);
}  // namespace rclcpp

namespace rclcpp_lifecycle
{
class State
{
public:
  std::uint8_t id() const;
  std::string label() const;
};

class LifecycleNode
{
public:
  enum class CallbackReturn : std::uint8_t {SUCCESS, FAILURE, ERROR};

  LifecycleNode(const std::string & name, const rclcpp::NodeOptions & options);
  virtual ~LifecycleNode();
  virtual CallbackReturn on_configure(const State & previous);
  virtual CallbackReturn on_activate(const State & previous);
  virtual CallbackReturn on_deactivate(const State & previous);
  virtual CallbackReturn on_cleanup(const State & previous);
  virtual CallbackReturn on_shutdown(const State & previous);
  virtual CallbackReturn on_error(const State & previous);

  const State & get_current_state();
  const State & configure();
  const State & activate();
  const State & deactivate();
  const State & cleanup();
  const State & shutdown();

  const char * get_name() const;
  rclcpp::Logger get_logger() const;
  rclcpp::Time now() const;
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface();

  template<typename Value>
  Value declare_parameter(
    const std::string & name, const Value & value,
    const rcl_interfaces::msg::ParameterDescriptor & descriptor);
  rclcpp::Parameter get_parameter(const std::string & name) const;
  std::shared_ptr<void> add_on_set_parameters_callback(
    std::function<rcl_interfaces::msg::SetParametersResult(
      const std::vector<rclcpp::Parameter> &)> callback);

  rclcpp::CallbackGroup::SharedPtr create_callback_group(
    rclcpp::CallbackGroupType type, bool is_added_to_executor = true);
  template<typename Duration, typename Callback>
  rclcpp::TimerBase::SharedPtr create_wall_timer(
    Duration, Callback, rclcpp::CallbackGroup::SharedPtr = nullptr) {return nullptr;}
  template<typename Type>
  std::shared_ptr<rclcpp::Client<Type>> create_client(
    const std::string & name,
    const rmw_qos_profile_t & qos = rmw_qos_profile_services_default,
    rclcpp::CallbackGroup::SharedPtr group = nullptr);
  template<typename Type, typename Callback>
  std::shared_ptr<rclcpp::Service<Type>> create_service(
    const std::string &, Callback &&,
    const rmw_qos_profile_t & = rmw_qos_profile_services_default,
    rclcpp::CallbackGroup::SharedPtr = nullptr) {return nullptr;}
};
}  // namespace rclcpp_lifecycle
