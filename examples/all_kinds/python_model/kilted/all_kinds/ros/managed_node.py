# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""A managed node whose logic runs in threads of its own."""

from __future__ import annotations

from concurrent.futures import Future, wait
from contextlib import ExitStack
from dataclasses import replace
from functools import partial
from math import isfinite
from time import monotonic
import traceback
from typing import Any, Callable, Optional, Sequence

from all_kinds.ros import timeouts
from all_kinds.ros.action_client import ActionClient
from all_kinds.ros.action_server import ActionServer
from all_kinds.ros.callbacks import CallbackThread
from all_kinds.ros.logic_thread import LogicThread
from all_kinds.ros.loop import Loop
from all_kinds.ros.ros_time import RosTime
from all_kinds.ros.service_client import ServiceClient
from all_kinds.ros.stop import Stop
from all_kinds.ros.worker import Worker
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.callback_groups import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)
from rclpy.client import Client
from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.qos import qos_profile_services_default, QoSPolicyKind, QoSProfile
from rclpy.qos_overriding_options import QoSOverridingOptions
import rclpy.task

OVERRIDABLE_QOS = (
    QoSPolicyKind.DEPTH,
    QoSPolicyKind.DURABILITY,
    QoSPolicyKind.HISTORY,
    QoSPolicyKind.RELIABILITY,
)


class ManagedNode(LifecycleNode):
    """
    The base of the nodes; calls their logic in other threads, and limits the time to wait.

    fixed_parameters: parameters that only change while the node is unconfigured.
    topic_parameters: parameters that have names of topics.
    loop: calls update while the node is active, if there is one.
    reconfigures: whether the logic gets changed parameters, which it may refuse.
    failed: whether the logic failed or refused to autostart.
    has_error: whether the logic has failed since it was configured.
    failure: why it has, or what it has refused.
    on_failure: called when the node has failed and deactivated.
    """

    fixed_parameters: Sequence[str] = ()

    topic_parameters: Sequence[str] = ()

    reconfigures = False

    def __init__(self, name: str, **options: Any) -> None:
        """Declare the parameters that every node has."""
        super().__init__(name, **options)
        self._ranged: set[str] = set()
        self.add_on_set_parameters_callback(self._check_parameters)
        what = 'Whether the node configures and activates itself.'
        self._declare('autostart', True, ParameterDescriptor(description=what, read_only=True))
        what = 'Time that the logic has to return when the node stops, s'
        limits = [FloatingPointRange(from_value=0.0, to_value=3600.0)]
        descriptor = ParameterDescriptor(description=what, floating_point_range=limits)
        self._declare('stop_timeout', timeouts.STOP_TIMEOUT, descriptor)
        self.failed = False
        self.has_error = False
        self.failure = ''
        self.on_failure: Callable[[], object] = lambda: None
        self.stop = Stop()
        self._time = RosTime(self, self.stop)
        self.loop: Optional[Loop] = None
        self._loops: dict[str, Loop] = {}
        self._config: Any = None
        self._impl: Any = None
        self._is_configured = False
        self._is_destroyed = False
        self._ack_deadline = 0.0
        self._diagnostics_publisher: Any = None
        self._configured = ExitStack()
        self._active = ExitStack()
        self._logic = LogicThread(
            self.stop,
            self._stop_timeout,
            self.get_logger().error,
            self.fail,
        )
        self._threads: dict[str, CallbackThread] = {}
        self._action_clients: list[ActionClient] = []
        self._action_servers: list[ActionServer] = []
        self._servers: dict[str, Any] = {}
        steady_clock = Clock(clock_type=ClockType.STEADY_TIME)
        self.create_timer(timeouts.SERVER_CHECK_PERIOD, self._watch_servers, clock=steady_clock)
        # rclpy 9.1.2 runs transitions in the executor; they would block it while they wait for the
        # logic, which may wait for a response that the executor receives.
        self._transitions = Worker('transitions')
        self._change_state = self._service_change_state.callback
        self._service_change_state.callback = self._change_state_in_thread

    def _read_config(self) -> Any:
        """Return the current parameters."""
        raise NotImplementedError

    def _connect_senders(self) -> None:
        """Create publishers and clients, then the logic."""
        raise NotImplementedError

    def _connect_receivers(self) -> None:
        """Create subscriptions and servers."""
        raise NotImplementedError

    def _publish_diagnostics(self) -> None:
        """Publish how the node is, if it has diagnostics."""

    @property
    def state(self) -> str:
        """Return the state of the lifecycle."""
        return self._state_machine.current_state[1]

    def start(self) -> None:
        """Configure and activate the node if autostart is true; do not wait for it."""
        if self.get_parameter('autostart').value:
            self._transitions.submit(self._start)

    def end(self) -> bool:
        """Deactivate, clean up and finalize; return whether the logic has returned."""
        self._logic.end()
        self._transitions.submit(self._shut_down).result()
        return not self._still_running()

    def destroy_node(self) -> None:
        """Shut down, then destroy the node."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        self.end()
        self._logic.close()
        self._transitions.close()
        for thread in self._threads.values():
            thread.close()
        self._time.close()
        super().destroy_node()

    def fail(self, error: BaseException) -> None:
        """Log an exception of the logic and take the node through error processing."""
        lines = traceback.format_exception(type(error), error, error.__traceback__)
        reason = traceback.format_exception_only(type(error), error)
        self._give_up(''.join(lines), ''.join(reason))

    def fail_because(self, reason: str) -> None:
        """Log why the logic cannot go on, and take the node through error processing."""
        self._give_up(f'The logic failed: {reason}')

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create publishers and clients, then configure the logic."""
        for name in self.topic_parameters:
            value = self.get_parameter(name).value
            is_one = isinstance(value, str)
            topics = [value] if is_one else list(value)
            wanted = 'be the name of a topic' if is_one else 'have names of topics, each once'
            for topic in topics:
                found = f'{topic!r} twice' if topics.count(topic) > 1 else ''
                try:
                    self.resolve_topic_name(topic)
                except Exception:  # RCLError, which rclpy 9.1.2 has in a private module
                    found = repr(topic)
                if found:
                    return self._refuse(f'Parameter {name} must {wanted}, not {found}.')
        result = self._begin('configure', self._connect_and_configure)
        if result == TransitionCallbackReturn.FAILURE:
            self._clean_up()
        return self._result() if result == TransitionCallbackReturn.SUCCESS else result

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Activate the logic, create subscriptions and servers, and start the loop."""
        result = self._begin('activate', self._impl.activate)
        if result != TransitionCallbackReturn.SUCCESS:
            return result
        try:
            self._connect_receivers()
        except Exception as error:  # such as an invalid QoS override
            self.fail(error)
        if self.has_error:
            self._deactivate()
            return self._result()
        if self.loop:
            self._logic.loop('update', self.loop.run, self.stop)
        return result

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the loop and the callbacks, deactivate the logic, and cancel its goals."""
        self._deactivate()
        return self._result()

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean up the logic, then destroy publishers and clients."""
        self._clean_up()
        return self._result()

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Deactivate and clean up, whatever the state."""
        if state.label == 'active':
            self._deactivate()
        self._clean_up()
        return TransitionCallbackReturn.SUCCESS if self._logic.is_ending else self._result()

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean up after a failure of the logic."""
        if self._diagnostics_publisher:  # before the process ends
            self._publish_diagnostics()
            limit = Duration(seconds=timeouts.ACKNOWLEDGE_TIMEOUT)
            self._diagnostics_publisher.wait_for_all_acked(limit)
        self._clean_up()
        return TransitionCallbackReturn.SUCCESS

    def _callback(self, name: str, method: str, count: int = 1) -> CallbackThread:
        """Return the thread of a callback of the logic, the same in every activation."""
        if method not in self._threads:
            self._threads[method] = CallbackThread(self, name, method, count)
        return self._threads[method]

    def _declare(self, name: str, value: Any, descriptor: ParameterDescriptor) -> None:
        if descriptor.floating_point_range:
            self._ranged.add(name)
        self.declare_parameter(name, value, descriptor)

    def _declare_list(
        self,
        name: str,
        type_: Parameter.Type,
        value: Any,
        descriptor: ParameterDescriptor,
    ) -> None:
        """Declare a list."""
        self.declare_parameter(name, type_, descriptor)
        if self.get_parameter_or(name).type_ != Parameter.Type.NOT_SET:
            return
        if name in self._parameter_overrides:
            value = []  # as given: rclpy cannot tell the type of an empty list
        self.set_parameters([Parameter(name, type_, value)])

    def _declare_frequency(self, frequency: float) -> float:
        """Declare how often update runs, in Hz; return what is given when the node starts."""
        descriptor = ParameterDescriptor(description='How often update runs, Hz', read_only=True)
        descriptor.floating_point_range = [FloatingPointRange(from_value=1e-3, to_value=1e5)]
        self._declare('frequency', float(frequency), descriptor)
        return float(self.get_parameter('frequency').value)

    def _check_parameters(self, parameters: list[Parameter[Any]]) -> SetParametersResult:
        """Refuse NaN and infinity, as rclpy 9.1.2 does not; and changes of what is fixed."""
        for parameter in parameters:
            name, value = parameter.name, parameter.value
            if name in self._ranged and isinstance(value, float) and not isfinite(value):
                reason = f'{name} must be a finite number.'
                return SetParametersResult(successful=False, reason=reason)
            if name in self.fixed_parameters and self.state != 'unconfigured':
                reason = f'{name} can be changed only while the node is unconfigured.'
                return SetParametersResult(successful=False, reason=reason)
        return SetParametersResult(successful=True)

    def _reconfigure(self, parameters: list[Parameter[Any]]) -> SetParametersResult:
        """Let the logic take the parameters about to be set, unless they are refused before."""
        result = self._check_parameters(parameters)  # rclpy calls this one first
        impl, is_configured = self._impl, self._is_configured
        if not (result.successful and self.reconfigures and impl and is_configured):
            return result
        config = self._config_with(parameters)
        if config == self._config:  # such as QoS, which is declared when a topic is made
            return result
        reason = self._logic.reconfigure(lambda: impl.reconfigure(config))
        return SetParametersResult(successful=not reason, reason=reason)

    def _config_with(self, parameters: list[Parameter[Any]]) -> Any:
        """Return the configuration with some parameters changed."""
        changed = {
            parameter.name: tuple(parameter.value)
            if parameter.type_.value > 4
            else parameter.value
            for parameter in parameters
            if hasattr(self._config, parameter.name)
        }
        return replace(self._config, **changed)

    def _apply_parameters(self, _parameters: list[Parameter[Any]]) -> None:
        """Update the configuration with the changed parameters."""
        self._config = self._read_config()

    def _advertise(self, message_type: Any, topic: str, qos: Any = 10) -> Publisher[Any]:
        """Create a publisher; its QoS, a profile or a depth, can be overridden."""
        publisher = self.create_publisher(
            message_type,
            topic,
            qos,
            qos_overriding_options=QoSOverridingOptions(OVERRIDABLE_QOS),
        )
        self._configured.callback(self._drop_publisher, publisher)
        return publisher

    def _drop_publisher(self, publisher: Publisher[Any]) -> None:
        """Destroy a publisher when its last messages have been acknowledged."""
        publisher.wait_for_all_acked(Duration(seconds=max(0.0, self._ack_deadline - monotonic())))
        self.destroy_publisher(publisher)

    def _subscribe(
        self,
        message_type: Any,
        topic: str,
        callback: Callable[[Any], Any],
        qos: Any = 10,
        callback_group: Optional[CallbackGroup] = None,
    ) -> None:
        """Create a subscription; its QoS, a profile or a depth, can be overridden."""
        subscription = self.create_subscription(
            message_type,
            topic,
            callback,
            qos,
            callback_group=callback_group or MutuallyExclusiveCallbackGroup(),
            qos_overriding_options=QoSOverridingOptions(OVERRIDABLE_QOS),
        )
        self._active.callback(self.destroy_subscription, subscription)

    def _service_client(
        self,
        service_type: Any,
        name: str,
        qos: QoSProfile = qos_profile_services_default,
    ) -> ServiceClient:
        """Create a client of a service."""
        client: Client[Any, Any] = self.create_client(
            service_type,
            name,
            qos_profile=qos,
            callback_group=ReentrantCallbackGroup(),
        )
        self._configured.callback(self.destroy_client, client)
        service_client = ServiceClient(client, self.stop)
        self._servers['service ' + name] = service_client
        return service_client

    def _serve(
        self,
        service_type: Any,
        name: str,
        method: str,
        qos: QoSProfile = qos_profile_services_default,
    ) -> None:
        """Create a server of a service that a method of the logic serves."""
        service = self.create_service(
            service_type,
            name,
            self._callback(name, method).serve,
            qos_profile=qos,
            callback_group=MutuallyExclusiveCallbackGroup(),
        )
        self._active.callback(self.destroy_service, service)

    def _action_client(self, action_type: Any, name: str) -> ActionClient:
        """Create a client of an action; it stays until the node is destroyed."""
        client = ActionClient(self, action_type, name)
        self._action_clients.append(client)
        self._servers['action ' + name] = client
        return client

    def _action_server(
        self,
        action_type: Any,
        name: str,
        method: str,
        new_goal: str,
        accept: str = '',
        at_once: int = 1,
    ) -> ActionServer:
        """Create a server of an action; it stays until the node is destroyed."""
        callback = self._callback(name, method, at_once)
        asks = self._callback(name, accept) if accept else None
        server = ActionServer(self, action_type, name, callback, self.stop, new_goal, asks)
        self._action_servers.append(server)
        return server

    def _watch_servers(self) -> None:
        """Warn about servers that are not available; give up the goals of a lost one."""
        for client in self._action_clients:
            client.watch()
        if self.state != 'active':
            return
        missing = [name for name, client in self._servers.items() if not client.is_ready()]
        if missing:
            self.get_logger().warning(
                'Waiting for ' + ', '.join(missing) + '.',
                throttle_duration_sec=timeouts.WARNING_PERIOD,
            )

    def call(self, method: str, *arguments: Any) -> Any:
        """Call a method of the logic."""
        return getattr(self._impl, method)(*arguments)

    def _call_at(self, frequency: float, method: str) -> None:
        """Call a method of the logic at a frequency, in a thread of its own."""
        if method not in self._loops:
            call = partial(self.call, method)
            self._loops[method] = Loop(
                call, frequency, self._time, self.get_logger().warning, method
            )
        self._logic.beside(method, self._loops[method].run, self.stop)

    async def await_first(self, *calls: Future[Any]) -> None:
        """Await the first of some calls in other threads."""
        executor = self.executor
        assert executor is not None
        completed: rclpy.task.Future[None] = rclpy.task.Future(executor=executor)

        def complete(_: Future[Any]) -> None:
            completed.set_result(None)
            executor.wake()  # a future of rclpy 9.1.2 does not wake it

        for call in calls:
            call.add_done_callback(complete)
        await completed

    async def _change_state_in_thread(self, request: Any, response: Any) -> Any:
        call = self._transitions.submit(self._change_state, request, response)
        await self.await_first(call)
        return call.result()

    def _start(self) -> None:
        if self.trigger_configure() == TransitionCallbackReturn.SUCCESS:
            if self.trigger_activate() == TransitionCallbackReturn.SUCCESS:
                return
        if not self.has_error and not self._logic.is_ending:
            self._leave()

    def _shut_down(self) -> None:
        if self.state != 'finalized':
            self.trigger_shutdown()

    def _give_up(self, text: str, reason: str = '') -> None:
        self.failure = self.failure or ' '.join((reason or text).split())
        self.has_error = True
        self.get_logger().error(text)
        self._transitions.submit(self._leave)

    def _leave(self) -> None:
        """Go to error processing after a failure, unless a transition has; call on_failure."""
        if self.state == 'active':
            self.trigger_deactivate()
        elif self.state == 'inactive' and self.has_error:
            self.trigger_cleanup()
        self.failed = True
        self.on_failure()

    def _result(self) -> TransitionCallbackReturn:
        if self.has_error:
            return TransitionCallbackReturn.ERROR
        return TransitionCallbackReturn.SUCCESS

    def _begin(self, name: str, method: Callable[[], bool]) -> TransitionCallbackReturn:
        """Call configure or activate, unless an earlier call is still running."""
        running = self._still_running()
        if running:
            return self._refuse(f'Cannot {name}: {running} has not returned.')
        if not self.has_error:
            self.failure = ''
        if self._logic.begin(name, method):
            return TransitionCallbackReturn.SUCCESS
        if self.has_error:
            return TransitionCallbackReturn.ERROR
        if self._logic.is_ending:
            return TransitionCallbackReturn.FAILURE
        return self._refuse(f'The logic refused to {name}.')

    def _refuse(self, reason: str) -> TransitionCallbackReturn:
        """Say why a transition fails."""
        self.failure = reason
        self.get_logger().error(reason)
        return TransitionCallbackReturn.FAILURE

    def _connect_and_configure(self) -> bool:
        self.has_error = False
        self.failure = ''
        self._config = self._read_config()
        self._connect_senders()
        if not self._logic.is_ending:
            self._is_configured = bool(self._impl.configure(self._config))
        return self._is_configured

    def _deactivate(self) -> None:
        self.stop.request()
        for server in self._action_servers:
            server.accept_goals(False)
        under_way = self._logic.pending()
        for callback in self._threads.values():
            under_way.update(callback.under_way())
        self._logic.have_returned(under_way)
        for server in self._action_servers:
            server.give_up()
        self._active.close()
        self._logic.finish('deactivate', self._impl.deactivate)
        for client in self._action_clients:
            client.cancel()
        unanswered = [goal for client in self._action_clients for goal in client.unanswered()]
        wait(unanswered, self._stop_timeout())  # canceled once they are accepted

    def _clean_up(self) -> None:
        if self._is_configured:
            self._is_configured = False
            self._logic.finish('cleanup', self._impl.cleanup)
        for server in self._action_servers:
            server.flush()
        self._logic.finish('cleanup', self._disconnect_senders)

    def _disconnect_senders(self) -> None:
        self._ack_deadline = monotonic() + timeouts.ACKNOWLEDGE_TIMEOUT
        self._configured.close()
        self._impl = None

    def _still_running(self) -> str:
        names = [callback.name for callback in self._threads.values() if callback.is_running()]
        return ', '.join([*self._logic.pending().values(), *names])

    def _stop_timeout(self) -> float:
        return float(self.get_parameter('stop_timeout').value)
