# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Tests that every node passes; test_NODE_node.py says what the node is in ROS."""

from concurrent.futures import ThreadPoolExecutor
import inspect
import itertools
from pathlib import Path
import re
from signal import SIGINT as INT, SIGTERM as TERM
from time import monotonic, sleep

from diagnostic_msgs.msg import DiagnosticStatus
from support.peer import decode, encode, parts, Peer, sample, stamped
from support.running import eventually, LIFE, RunningNode, TIMEOUT
import yaml

OK, WARN, ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR
TOPICS = ('out_', 'pub_', 'in_', 'receive_', 'input_')


class NodeTests:
    """Tests of a node in processes of its own, with a logic that obeys them."""

    deadlines = {}
    diagnostics = False
    frequency = None
    interfaces = {}
    can_refuse = ()
    transforms = ()
    synchronizers = {}
    threads = ()
    timers = {}
    parameters = {}
    dynamic_parameters = {}
    reconfigures = False

    @classmethod
    def setUpClass(cls):
        """Start a node as it is, and one with all its parameters set."""
        cls.root = Path(inspect.getfile(cls)).resolve().parents[1]
        cls.numbers = itertools.count(1)
        cls.peer = Peer()
        cls.begun = monotonic()
        cls.given = cls.active(_override=True)
        cls.node = cls.active()

    @classmethod
    def tearDownClass(cls):
        """Stop the nodes, which must still run."""
        for node in cls.node, cls.given:
            node.signal(INT)
            assert (node.exit_code(), node.life()[-2:]) == (0, LIFE[2:]), node.log
        for text in 'Waiting for ', 'Missed ', 'without an outcome', 'Parameters refused':
            lines = [line for line in cls.node.log.splitlines() if text in line]
            assert all('WARN' in line for line in lines), lines
        warnings = cls.node.log.count('Waiting for ')  # for servers, at most once in 10 s
        assert warnings < 2 + (monotonic() - cls.begun) / 9.0, cls.node.log

    @classmethod
    def active(cls, /, *orders, **given):
        """Start a node, wait until it is active, and return it."""
        node = cls.start(*orders, **given)
        assert eventually(lambda: node.got('activate')), node.log
        return node

    @classmethod
    def start(cls, /, *orders, _command=None, _override=False, **given):
        """Start the node in a namespace of its own, and return it; no parameter begins with _."""
        space = f'/test{next(cls.numbers)}'
        node = f'{space}/{cls.name}'
        if _override:
            given = {**cls.others(), **given}
        cls.peer.give(node, given, use_sim_time=_override)
        command = [*(_command or cls.recorder), '__ns:=' + space]
        for _, name, *_ in cls.endpoints(_override):
            command += [f'{name}:={space}/absolute{name}'] if name[0] == '/' else []
        running = RunningNode(node, command, *orders)
        cls.addClassCleanup(running.kill)
        return running

    @classmethod
    def others(cls):
        """Return other values of the parameters than their defaults."""
        every = {**cls.parameters, **cls.dynamic_parameters}.items()
        return {name: others[0] for name, (_, others, _) in every if others}

    @classmethod
    def each(cls, *members, node=None, given=False):
        """Return member, full name, type and more of each interface, or all of a kind."""
        node = node or cls.node.name
        kinds = tuple(each for each in members if each.endswith('_'))
        for member, name, *rest in cls.endpoints(given):
            if member in members or member.startswith(kinds):
                space = {'~': node, '/': node.rpartition('/')[0] + '/absolute'}
                start = space.get(name[0], node.rpartition('/')[0] + '/')
                yield (member, start + name.lstrip('~'), *rest)

    @classmethod
    def named(cls, name, given):
        """Return a name, or what is in the parameter which stands for it: {topic}."""
        if name[0] != '{':
            return name
        default, others, _ = cls.parameters[name[1:-1]]
        return others[0] if given or default is None else default

    @classmethod
    def endpoints(cls, given):
        """Yield member, name, type and more of each interface; MEMBER.TOPIC of a list."""
        for member, (name, *rest) in cls.interfaces.items():
            found = cls.named(name, given)
            if isinstance(found, str):
                yield (member, found, *rest)
            else:
                yield from ((f'{member}.{topic}', topic, *rest) for topic in found)

    def name_of(self, member, node):
        """Return the full name of an interface of a node."""
        return {each: name for each, name, *_ in self.each(member, node=node.name)}[member]

    def test_topics(self):
        """Every topic has its name and type; those of publishers are latched as specified."""
        for node in self.node, self.given:
            for _, topic, type_, kind, *qos, _ in self.each(
                *TOPICS, node=node.name, given=node is self.given
            ):
                expected = (node, kind, topic, type_, *qos)
                self.assertTrue(eventually(lambda: self.peer.has(*expected)), expected)

    def lates(self):
        """Return the methods for topics that are late soon, with interface and deadline (s)."""
        short = [item for item in self.deadlines.items() if item[1] <= 5.0]
        return [('late_' + member.partition('_')[2], member, time) for member, time in short]

    def test_deadlines(self):
        """A topic is late once when no message has come for so long, and again after the next."""
        simulated = self.active(_override=True)
        node = self.start()
        for late, *_ in self.lates():
            self.assertTrue(eventually(lambda: node.got(late)), late)
        sleep(2 * max([deadline for *_, deadline in self.lates()], default=0))
        for late, member, deadline in self.lates():
            self.assertEqual(node.got(late), [late[:15]])  # the name of its thread
            _, topic, type_, _, *qos, _ = next(self.each(member, node=node.name))
            publisher = self.peer.publisher(type_, topic, *qos)
            begin = monotonic()
            least = deadline
            if member.startswith('receive_'):  # while the logic is at work it is not late
                node.order(member, f'wait={deadline}')
                least = 2 * deadline
            message = sample(type_, 1)

            def is_received():  # once, unless it is lost
                publisher.publish(message)
                return eventually(lambda: node.got(member), 1.0)

            self.assertTrue(eventually(is_received), member)
            self.assertTrue(eventually(lambda: node.got(late)[1:]), late)
            self.assertGreaterEqual(monotonic() - begin, least)
            self.assertEqual(simulated.got(late), [])  # its time has not begun

    def test_transforms(self):
        """Transforms are sent as the logic says, and found as others send them."""
        for member in self.transforms:
            for topic, durability in (('/tf', 'volatile'), ('/tf_static', 'transient_local')):
                is_sent = member.startswith('broadcaster_')
                test = self.sends_transforms if is_sent else self.finds_transforms
                test(member, topic, 'reliable', durability)

    def sends_transforms(self, member, topic, *qos):
        """See that transforms are sent; static ones together, also to those who come later."""
        from tf2_msgs.msg import TFMessage  # only for nodes with transforms

        step = 'static_' + member if topic == '/tf_static' else member
        steps = [f'{step}=map,{child},2.5' for child in 'ab']
        self.node.order('now', *steps)
        count, children = (1, 'ab') if topic == '/tf_static' else (4, 'abab')  # each once
        got = self.peer.subscribe(TFMessage, topic, *qos)

        def is_sent():
            if topic == '/tf':
                self.node.order('now', *steps)
            return [
                [
                    tf.child_frame_id,
                    tf.header.frame_id,
                    tf.transform.translation.x,
                    tf.transform.translation.z,
                    tf.transform.rotation.z,
                ]
                for message in got[-count:]
                for tf in message.transforms
                if tf.header.stamp.secs
            ] == [[child, 'map', 2.5, 2.0, 0.8] for child in children]

        self.assertTrue(eventually(is_sent), (topic, got))

    def finds_transforms(self, member, topic, *qos):
        """See that a lookup finds a transform, waits for one, and no longer than it may."""
        from geometry_msgs.msg import TransformStamped
        from tf2_msgs.msg import TFMessage

        frame = topic.strip('/')
        publisher = self.peer.publisher(TFMessage, topic, *qos)
        self.assertIn('does not exist', self.node.order('now', f'{member}=map,{frame},0.1'))

        def is_at_once():  # without a timeout
            begin = monotonic()
            self.node.order('now', f'{member}=map,{frame}')
            return monotonic() - begin < 0.5

        self.assertTrue(eventually(is_at_once), member)
        begun = len(self.node.got('begun'))
        with ThreadPoolExecutor() as pool:
            found = pool.submit(self.node.order, 'now', f'{member}=map,{frame},{TIMEOUT}')
            self.assertTrue(eventually(lambda: len(self.node.got('begun')) > begun))
            transform = TransformStamped(child_frame_id=frame)
            transform.header.frame_id = 'map'
            transform.transform.translation.x = 2.5
            transform.transform.rotation.w = 1.0
            message = TFMessage(transforms=[transform])
            self.assertTrue(eventually(lambda: publisher.publish(message) or found.done()))
            self.assertEqual(found.result(), 2.5)
        if topic == '/tf':  # a time at which it is not known
            reason = self.node.order('now', f'{member}=map,{frame},0,9')
            self.assertIn('extrapolation', reason)

    def test_messages_in(self):
        """Every message reaches the logic as it was sent, once."""
        for member, topic, type_, _, *qos, depth in self.each('in_', 'receive_'):
            publisher = self.peer.publisher(type_, topic, *qos)
            before = len(self.node.got(member))  # of a topic that is heard twice

            def got():
                return [decode(text, type_) for text in self.node.got(member)[before:]]

            first, *messages = (sample(type_, number) for number in (1, 2, 3))
            self.assertTrue(eventually(lambda: publisher.publish(first) or got()), topic)
            for message in messages:
                publisher.publish(message)
                self.assertTrue(eventually(lambda: message in got()), topic)
            if member.startswith('receive_'):  # and waits where the logic does not receive it yet
                self.node.order(member, 'block')
                more = [sample(type_, number) for number in range(4, min(depth or 5, 5) + 5)]
                publisher.publish(more[0])
                self.assertTrue(eventually(lambda: more[0] in got()), topic)
                for message in more[1:]:
                    publisher.publish(message)
                self.release()
                self.assertTrue(eventually(lambda: more[-1] in got()), topic)
                messages += more
            if member.startswith('in_'):  # of two in a cycle, the latest
                begun = len(self.node.got('begun'))
                self.node.order('update', 'wait=0.3')
                self.assertTrue(eventually(lambda: len(self.node.got('begun')) > begun))
                messages.append(sample(type_, 4))
                for message in first, messages[-1]:
                    publisher.publish(message)
                self.assertTrue(eventually(lambda: messages[-1] in got()), topic)
                messages.append(messages[-1])  # the same again is new, too
                publisher.publish(messages[-1])
                self.assertTrue(eventually(lambda: got()[-2:] == messages[-2:]), topic)
            self.turns(more=3)
            self.assertEqual(*([one for one in lot if one != first] for lot in (got(), messages)))

    def test_messages_out(self):
        """Every message is published as the logic says, and where it says so."""
        for member, topic, type_, _, *qos, depth in self.each('out_', 'pub_'):
            method = 'update' if member.startswith('out_') else 'now'
            count = 'subscribers_' + member

            def heard():
                answers = len(self.node.got(count))
                self.node.order(method, count)
                self.assertTrue(eventually(lambda: self.node.got(count)[answers:]), topic)
                return self.node.got(count)[-1]

            before = heard()
            got = self.peer.subscribe(type_, topic, *qos)

            def publish(number, count=1):
                message = sample(type_, number)
                self.node.order(method, f'{member}={encode(message)}')
                timeout = 0.5 if number == 1 else TIMEOUT
                return eventually(lambda: got.count(message) >= count, timeout)

            self.assertTrue(eventually(lambda: publish(1)), topic)
            self.assertTrue(eventually(lambda: heard() == before + 1), topic)
            for number, count in ((2, 1), (3, 1), (3, 2)):  # the same again, too
                self.assertTrue(publish(number, count), topic)
                self.turns(more=2)
            first, *rest = (sample(type_, number) for number in (1, 2, 3, 3))
            if member.startswith('pub_'):  # as many at once as may wait
                more = [sample(type_, number) for number in range(4, min(depth or 5, 5) + 4)]
                self.node.order('now', *(f'{member}={encode(each)}' for each in more))
                self.assertTrue(eventually(lambda: more[-1] in got), topic)
                rest += more
            self.assertEqual(*([one for one in lot if one != first] for lot in (got, rest)))

    def test_last_words(self):
        """What the logic publishes last leaves the node."""
        node = self.active()
        heard, steps = [], []
        for member, topic, type_, _, *qos, _ in self.each('pub_', node=node.name):
            got = self.peer.subscribe(type_, topic, *qos)
            first, last = (f'{member}={encode(sample(type_, number))}' for number in (1, 2))
            self.assertTrue(eventually(lambda: node.order('now', first) or got), topic)
            heard.append((got, sample(type_, 2)))
            steps.append(last)
        node.order('cleanup', *steps)
        node.signal(INT)
        for got, last in heard:
            self.assertTrue(eventually(lambda: last in got), last)

    def sender(self, node, name):
        """Return a function that publishes messages for a synchronizer."""
        inputs = [each for each in self.interfaces if each.startswith(f'input_{name}.')]
        publishers = [
            (type_, self.peer.publisher(type_, topic, *qos))
            for _, topic, type_, _, *qos, _ in self.each(*inputs, node=node.name)
        ]

        def send(*apart):
            sent = []
            for seconds in apart or [0.0]:
                start = next(self.numbers) * (1.0 + 10.0 * self.synchronizers[name][0])
                stamps = [start] * (len(publishers) - 1) + [start + seconds]
                sent.append([stamped(type_, at) for (type_, _), at in zip(publishers, stamps)])
            for messages, (_, publisher) in zip(zip(*sent), publishers):
                for message in messages:  # which wait for those of other topics
                    publisher.publish(message)
                    sleep(0.01 if apart[2:] else 0.0)
            return sent

        return send

    def test_synchronizers(self):
        """Messages reach the logic together where their stamps belong together, and only there."""
        for name, (slop, size) in self.synchronizers.items():
            send = self.sender(self.node, name)
            types = [type(message) for message in send()[0]]

            def got():
                found = self.node.got(f'receive_{name}')
                return [list(map(decode, texts, types)) for texts in found]

            def reach(*apart):
                """Return whether what belongs together, and nothing else, reaches the logic."""
                count = len(got())
                sent = zip(send(*apart), apart)
                expected = [messages for messages, each in sent if each <= slop]
                eventually(lambda: expected[-1] in got(), TIMEOUT / 3)
                return got()[count:] == expected

            self.assertTrue(eventually(lambda: send() and got()), name)
            for apart in (slop / 2, 2 * slop or 0.5):
                # Best effort may lose a message.
                self.assertTrue(any(reach(apart, 0.0) for _ in range(3)), f'{name}: {apart} s')

            def keeps_the_newest():  # where more wait than may
                count = len(got())
                sent = send(*[0.0] * (size + 1))
                eventually(lambda: got()[count:][-1:] == sent[-1:], 2.0)
                return got()[count:] == sent[1:]

            self.assertTrue(size > 20 or eventually(keeps_the_newest), name)

    def release(self, count=1):
        """Let callbacks go on that block, or are about to."""
        count += len(self.node.got('block'))

        def are_released():
            is_done = len(self.node.got('block')) >= count
            return is_done or self.node.order('now', 'release')

        self.assertTrue(eventually(are_released))

    def callbacks(self):
        """Return the methods that messages, requests and goals call."""
        found = [member for member, *_ in self.each('receive_', 'serve_', 'execute_')]
        # The topics of a list share a callback: one of them stands for all.
        found = [*{member.partition('.')[0]: member for member in found}.values()]
        return found + [f'receive_{name}' for name in self.synchronizers]

    def trigger(self, node, member):
        """Have the node call a callback; return the goal, if it is that of one."""
        count = len(node.got(member))
        goal = None

        def is_called():
            return len(node.got(member)) > count

        for _, name, type_, *rest in self.each(member, node=node.name):
            if member.startswith('receive_'):
                publisher = self.peer.publisher(type_, name, *rest[1:3])
                eventually(lambda: publisher.publish(sample(type_, 1)) or is_called())
            if member.startswith('serve_'):
                self.peer.send(node, type_, name, type_._request_class())
            if member.startswith(('execute_', 'accept_')):
                goal = self.peer.goal(node, type_, name, parts(type_)[0]())
        if member.startswith('receive_') and member[8:] in self.synchronizers:
            send = self.sender(node, member[8:])
            eventually(lambda: is_called() or not send())
        self.assertTrue(eventually(is_called), member)
        return goal

    def test_callbacks(self):
        """Callbacks that block do not delay each other, nor the loop; threads have their names."""
        callbacks = self.callbacks()
        for member in callbacks:
            self.node.order(member, 'block')
            self.trigger(self.node, member)
        others = [each for each in self.each('receive_') if each[0] not in callbacks]
        called = [len(self.node.got(member)) for member, *_ in others]
        for _, topic, type_, _, *qos, _ in others:  # of a list, whose thread is busy
            self.peer.publisher(type_, topic, *qos).publish(sample(type_, 1))
        self.turns(more=3)
        self.assertEqual([len(self.node.got(member)) for member, *_ in others], called)
        self.release(len(callbacks))
        threads = {name.lstrip('~/').replace('/', '_')[:13] for name in self.node.got('block')}
        names = {member.partition('_')[2].partition('.')[0][:13] for member in callbacks}
        self.assertLessEqual(names, threads)  # Linux keeps 15 letters, with ~/

    def got(self, member, type_):
        """Return the last message that a callback got, in a list."""
        return [decode(text, type_) for text in self.node.got(member)[-1:]]

    def test_services(self):
        """Every service gets its requests, and responds as the logic does."""
        for member, name, type_ in self.each('serve_'):
            request, response = sample(type_._request_class), sample(type_._response_class, 5)
            self.node.order(member, 'response=' + encode(response))
            call = self.node, type_, name, request
            self.assertEqual(self.peer.call(*call), response)
            self.assertTrue(eventually(lambda: self.got(member, type(request)) == [request]), name)
            self.node.order(member, 'block')
            called = len(self.node.got(member)) + 1
            sent = [self.peer.send(*call) for _ in range(3)]
            self.assertTrue(eventually(lambda: len(self.node.got(member)) == called), name)
            self.turns(more=3)
            self.assertEqual(len(self.node.got(member)), called)  # one at a time
            self.release()
            self.assertTrue(eventually(lambda: all(each.done() for each in sent)), name)

    def test_service_clients(self):
        """Every client warns of a missing server, gives up in time, and gets its responses."""
        for member, name, type_ in self.each('client_'):
            request, response = sample(type_._request_class), sample(type_._response_class, 5)
            missing = 'service ' + self.interfaces[member][0]
            self.assertTrue(eventually(lambda: missing in self.given.log), missing)

            def waits():
                begin = monotonic()
                self.assertIsNone(self.given.order('now', f'{member}={encode(request)}'))
                self.assertGreaterEqual(monotonic() - begin, 0.9)  # a server may still come
                return monotonic() - begin

            self.assertTrue(eventually(lambda: waits() < 2.0), name)
            requests = self.peer.serve(type_, name, response)
            order = f'{member}={encode(request)},0.5'  # the first response comes later
            self.assertTrue(eventually(lambda: not self.node.order('now', order) and requests))
            requests.clear()
            got = self.node.order('now', f'{member}={encode(request)},1000')
            self.assertEqual((decode(got, type(response)), requests), (response, [request]))

    def test_action_servers(self):
        """Every action gets its goals and cancels, and sends feedback, results and outcomes."""
        for member, name, type_, policy, *_ in self.each('execute_'):
            types = parts(type_)
            request, feedback, result = map(sample, types, (3, 5, 7))
            steps = f'feedback={encode(feedback)}', f'result={encode(result)}'

            def send(*more):
                self.node.order(member, *steps, *more)
                goal = self.peer.goal(self.node, type_, name, request)
                self.assertTrue(eventually(lambda: goal.feedback == [feedback]), name)
                self.assertTrue(
                    eventually(lambda: self.got(member, type(request)) == [request]), name
                )
                return goal

            self.assertEqual(send('end=succeed').end(), ('succeeded', result))
            self.assertEqual(send('end=abort').end(), ('aborted', result))
            self.assertEqual(send().end(), ('aborted', result))
            self.assertTrue(eventually(lambda: 'without an outcome' in self.node.log), name)
            goal = send('await', 'end=canceled')
            goal.cancel()
            self.assertEqual(goal.end(), ('canceled', result))
            goal = send('block', *['await'] * (policy == 'replace'), 'end=succeed')
            self.node.order(member, 'end=succeed')
            waiting = policy in ('replace', 'queue') and self.peer.goal(
                self.node, type_, name, request
            )
            other = self.peer.goal(self.node, type_, name, request)
            if policy == 'queue':
                waiting.cancel()
            self.release()
            self.assertEqual(goal.end(), ('succeeded', result))
            if waiting:  # replaced or canceled before its turn
                self.assertEqual(waiting.end()[0], 'canceled')
            self.assertEqual(other is None, policy == 'reject')
            other = other or self.peer.goal(self.node, type_, name, request)
            self.assertEqual(other.end()[0], 'succeeded')
            node = self.active(' '.join((member, *steps, 'await', 'end=canceled')))
            goal = self.peer.goal(node, type_, self.name_of(member, node), request)
            self.assertTrue(eventually(lambda: node.got(member)), name)
            node.signal(INT)
            self.assertEqual(goal.end(), ('aborted', result))
            self.assertEqual((node.exit_code(), node.life()), (0, LIFE), node.log)
        members = [member for member, *_ in self.each('execute_')]
        if not members:
            return
        node = self.active(*(f'{member} block' for member in members * 2), stop_timeout=0.1)
        goals = []
        for member, name, type_, policy, *_ in self.each('execute_', node=node.name):
            for count in (1,) if policy == 'reject' else (1, 2):
                goals.append(self.peer.goal(node, type_, name, parts(type_)[0]()))
                called = count if policy == 'parallel' else 1  # the other waits
                self.assertTrue(eventually(lambda: len(node.got(member)) == called), name)
        node.signal(INT)
        for goal in goals:
            self.assertEqual(goal.end()[0], 'aborted')  # by the node: its logic does not return

    def test_parallel_goals(self):
        """As many goals as there may be are executed at once, each with its own result and end."""
        for member, name, type_, policy, *most in self.each('execute_'):
            if policy != 'parallel':
                continue
            types = parts(type_)
            request = sample(types[0], 3)
            results = [sample(types[2], number) for number in range(*most)]
            goals = []
            begun = self.node.got('begun').count('await')
            for result in results:
                self.node.order(member, 'result=' + encode(result), 'await', 'end=canceled')
                goals.append(self.peer.goal(self.node, type_, name, request))
                begun += 1
                self.assertTrue(eventually(lambda: self.node.got('begun').count('await') == begun))
            self.assertIsNone(self.peer.goal(self.node, type_, name, request))
            for goal, result in zip(reversed(goals), reversed(results)):
                goal.cancel()
                self.assertEqual(goal.end(), ('canceled', result))

    def test_accepted_goals(self):
        """The logic gets the goals to accept; one that it refuses leaves the current one alone."""
        for member, name, type_, policy, *_ in self.each('accept_'):
            request = sample(parts(type_)[0], 3)
            self.node.order(member, 'refuse')
            self.assertIsNone(self.peer.goal(self.node, type_, name, request))
            self.assertTrue(eventually(lambda: self.got(member, type(request)) == [request]), name)
            self.node.order(member.replace('accept', 'execute', 1), 'await', 'end=canceled')
            awaited = len(self.node.got('await'))
            goal = self.peer.goal(self.node, type_, name, request)
            if policy != 'reject':
                self.node.order(member, 'refuse')
            self.assertIsNone(self.peer.goal(self.node, type_, name, request))
            self.turns(more=3)
            self.assertEqual(len(self.node.got('await')), awaited)
            goal.cancel()
            self.assertEqual(goal.end()[0], 'canceled')

    def test_action_clients(self):
        """Every client sends its goals and cancels, and gets feedback, results and states."""
        for member, name, type_ in self.each('action_'):
            node = self.active()
            name = self.name_of(member, node)
            types = parts(type_)
            goal, feedback, result = map(sample, types, (3, 5, 7))
            send = f'{member}={encode(goal)}'

            def comes(*expected):
                def is_there():
                    if expected[0] == 'active':
                        server.feed_back()
                    state, *parts = node.order('now', 'state_' + member)
                    found = (part and decode(part, each) for part, each in zip(parts, types[1:]))
                    return (state, *found) == expected

                self.assertTrue(eventually(is_there), (name, expected))

            comes('idle', None, None)
            self.assertFalse(node.order('now', send))
            comes('lost', None, None)
            missing = 'action ' + self.interfaces[member][0]
            self.assertTrue(eventually(lambda: missing in node.log), missing)
            server = self.peer.execute(type_, name, feedback, result)
            self.assertTrue(eventually(lambda: node.order('now', send)), name)
            comes('active', feedback, None)
            for outcome in 'succeeded', 'aborted':
                server.finish(outcome)
                comes(outcome, feedback, result)
                node.order('now', send)
                comes('active', feedback, None)
            node.order('now', send)  # which cancels the one before
            self.assertTrue(eventually(lambda: server.cancels == 1), name)
            comes('active', feedback, None)
            node.order('now', member + '=')
            comes('canceled', feedback, result)
            server.rejects = True
            server.answers.clear()
            state = node.order('now', send, 'state_' + member)
            server.answers.set()
            self.assertEqual(state, ['pending', None, None])  # until it is accepted
            self.assertTrue(
                eventually(lambda: node.order('now', 'state_' + member)[0] == 'rejected'), name
            )
            server.rejects = False
            node.order('now', send)
            comes('active', feedback, None)
            self.assertEqual((server.goals, server.cancels), ([goal] * 6, 2))
            server.close()
            comes('lost', feedback, None)
            server = self.peer.execute(type_, name, feedback, result)
            self.assertTrue(eventually(lambda: node.order('now', send)), name)
            comes('active', feedback, None)
            node.order('deactivate', 'wait=0.2', 'state_' + member)
            node.signal(INT)
            self.assertTrue(eventually(lambda: server.cancels == 1))
            self.assertEqual(node.exit_code(), 0)
            self.assertEqual(node.got('state_' + member)[-1][0], 'active')  # in deactivate

    def test_rate(self):
        """Update is called at the frequency; cycles missed are skipped, and the log says so."""
        count = 5 + int((self.frequency or 0) / 5)

        def is_kept(node, frequency):
            told = node.log.count('Missed ')
            before, begin, _ = self.turns(node=node)
            after, end, _ = self.turns(node=node, more=count)
            cycles = (end - begin) * frequency
            missed = node.log.count('Missed ') > told  # as on a busy machine
            return after - before < 1.05 * cycles and (missed or after - before > 0.95 * cycles)

        if self.frequency:
            wrong = [self.start(frequency=each) for each in (0.0009, 2e5)]
            frequency = (0.5 if self.frequency > 25.0 else 2.0) * self.frequency
            started = monotonic()
            orders = [f'update wait={periods / frequency}' for periods in (3.5, 2.5)]
            other = self.start(*orders, frequency=frequency)
            self.assertTrue(eventually(lambda: is_kept(self.node, self.frequency)))
            self.assertTrue(eventually(lambda: other.got('wait')[1:]))
            self.assertTrue(eventually(lambda: is_kept(other, frequency)))
            self.assertRegex(other.log, r'Missed ([2-9]|[1-9]\d+) cycles .*update takes')
            told = other.log.count('update takes')  # at most once in 10 s
            self.assertLessEqual(told, 1 + (monotonic() - started) / 10)
            for each in wrong:
                self.assertEqual((each.exit_code(), each.life()), (1, []), each.log)

            def starts_at_once():
                waited = len(self.node.got('wait'))
                before, begin, _ = self.turns()
                self.node.order('update', f'wait={4.5 / self.frequency}')
                self.assertTrue(eventually(lambda: self.node.got('wait')[waited:]))
                after, end, _ = self.turns(more=3)
                lost = (end - begin) * self.frequency - (after - before)
                most = 3.5 if self.frequency < 50.0 else 1e3  # a busy machine misses fast cycles
                return 2.0 < lost < most

            self.assertTrue(eventually(starts_at_once))

    def test_simulated_time(self):
        """The loop and timers follow /clock, where it goes on, jumps back and stands still."""
        loops = {'update': self.frequency, **self.timers}
        for method in loops:
            self.assertEqual(self.turns(method, node=self.given)[0], 0, method)
        for thread in self.threads:  # which do not wait for it
            self.assertTrue(eventually(lambda: self.turns(thread, node=self.given)[0]), thread)
        for (method, frequency), time in itertools.product(loops.items(), (1000.0, 10.0)):
            ticks = []

            def is_regular():
                nonlocal time
                time += 0.25 / frequency
                self.peer.set_time(time)
                sleep(0.5 / frequency if frequency > 5.0 else 0.0)  # not at the speed of wall time
                tick = self.turns(method, node=self.given)[2]
                ticks.extend([tick] if tick not in ticks else [])
                cycles = [(end - start) * frequency for start, end in zip(ticks, ticks[1:])]
                return len(cycles) > 3 and all(0.7 < cycle < 1.3 for cycle in cycles[-3:])

            self.assertTrue(not frequency or eventually(is_regular), (method, ticks))
            last = self.turns(method, node=self.given)
            self.turns(method, more=3)
            self.assertEqual(self.turns(method, node=self.given), last)
        for late, member, deadline in self.lates():  # and so do deadlines
            _, topic, type_, _, *qos, _ = next(self.each(member, node=self.given.name, given=True))
            publisher = self.peer.publisher(type_, topic, *qos)
            message = sample(type_, 1)

            def is_late_in_time():
                nonlocal time
                heard, told = len(self.given.got(member)), len(self.given.got(late))
                eventually(
                    lambda: publisher.publish(message) or self.given.got(member)[heard:], 1.0
                )
                time += 1.5 * deadline
                return eventually(
                    lambda: self.peer.set_time(time) or self.given.got(late)[told:], 1.0
                )

            self.assertTrue(eventually(is_late_in_time), late)
        steps = itertools.count(1e4, 300.0)
        with ThreadPoolExecutor(1) as pool:  # and so does a sleep of the logic
            slept = pool.submit(self.given.order, 'now', 'sleep=1000')
            self.assertTrue(eventually(lambda: self.peer.set_time(next(steps)) or slept.done()))
            self.assertTrue(slept.result())

    def turns(self, method='update', more=0, node=None):
        """Wait for `more` calls of a method; return their number, and both times of the last."""

        def count():
            return (node or self.node).order('now', f'turns={method}')

        first = count()[0]
        more = more if self.frequency or method != 'update' else 0
        self.assertTrue(eventually(lambda: count()[0] >= first + more), method)
        return count()

    def test_threads(self):
        """Each thread and timer is called on and on, in a thread of its own, whatever blocks."""
        methods = [*self.threads, *self.timers]
        for method in methods:
            self.turns(method, more=2)
            self.node.order(method, 'block')
            self.assertTrue(eventually(lambda: self.node.got(method)), method)
            self.assertEqual(self.node.got(method)[-1], method[:15])
        self.turns(more=3)
        if methods:
            self.release(len(methods))
        for method in methods:
            self.turns(method, more=2)

    def test_timers(self):
        """Each timer is called at its frequency."""
        for timer, frequency in self.timers.items():
            count = 3 + int(frequency / 5)

            def rate():
                (before, begin, _), (after, end, _) = [
                    self.turns(timer, more) for more in (1, count)
                ]
                return (after - before) / (end - begin) / frequency

            self.assertTrue(eventually(lambda: 0.8 < rate() < 1.2), timer)
            self.node.order(timer, f'wait={2.5 / frequency}')
            self.assertTrue(eventually(lambda: f'{timer} takes too long' in self.node.log), timer)

    def test_parameters(self):
        """Parameters have their defaults, or what is given; their types and ranges are kept."""
        every = {**self.parameters, **self.dynamic_parameters}
        default = {name: value for name, (value, *_) in every.items()}
        given = {**default, **self.others()}
        self.assertEqual(self.node.got('config')[0], default)
        self.assertEqual(self.given.got('config')[0], given)
        for name, (value, others, refused) in self.dynamic_parameters.items():
            self.refuses(self.node, name, *refused[1:])
            if isinstance(value, float) and refused[1:]:
                self.refuses(self.node, name, float('nan'))
                self.assertTrue(eventually(lambda: self.node.got('config')[-1][name] == value))
            for other in reversed(others):
                self.sets(name, other)
            values = [config[name] for config in self.node.got('config')]
            self.assertEqual(values, [each for each in values if each == each])  # no NaN
        wrong = [(name, every[name][2][0]) for name in every]
        wrong += [(name, value) for name in self.parameters for value in every[name][2][1:]]
        with ThreadPoolExecutor(4) as pool:
            list(pool.map(self.ends_with, wrong))

    def test_reconfigure(self):
        """The logic can refuse changed parameters, which then stay as they are."""
        dynamic = self.dynamic_parameters if self.reconfigures else {}
        for name, (default, others, _) in dynamic.items():
            before = self.node.got('config')[-1]
            value = next(each for each in [default, *others] if each != before[name])
            self.node.order('reconfigure', 'refuse')
            self.assertFalse(self.peer.set_parameter(self.node, name, value), name)
            self.assertEqual(self.node.got('config')[-1], before)
            asked = {**before, name: value}
            self.assertTrue(eventually(lambda: self.node.got('reconfigure')[-1:] == [asked]), name)
            self.assertTrue(eventually(lambda: 'told to refuse' in self.node.log), name)
            self.sets(name, value)
        for name, (default, others, _) in itertools.islice(dynamic.items(), 1):
            node = self.active()
            value = next(each for each in others if each != default)
            node.order('reconfigure', 'raise')
            self.assertFalse(self.peer.set_parameter(node, name, value), name)
            self.assertEqual((node.exit_code(), node.life()), (1, LIFE), node.log)

    def test_names_of_topics(self):
        """Without names of topics, each once, in its parameters the node refuses to configure."""
        wrong = []
        for name in (name[1:-1] for name, *_ in self.interfaces.values() if name[0] == '{'):
            is_list = isinstance(self.named('{' + name + '}', True), list)
            values = [['a b'], ['a', 'a']] if is_list else ['a b']
            wrong += [(name, each) for each in values]
        with ThreadPoolExecutor(4) as pool:
            list(pool.map(self.ends_with, wrong))

    def ends_with(self, case):
        """Check that a node ends that starts with a wrong parameter, and names it."""
        node = self.start(**dict([case]))
        self.assertEqual((node.exit_code(), node.life()), (1, []), (case, node.log))
        self.assertRegex(node.log, f'(ERROR|FATAL).*{case[0]}')
        self.assertNotIn('Traceback', node.log)

    def refuses(self, node, name, *values):
        """See that a parameter refuses some values."""
        for value in values:
            self.assertFalse(self.peer.set_parameter(node, name, value), (name, value))

    def sets(self, name, value):
        """Set a parameter, and see that the logic gets it."""
        self.assertTrue(self.peer.set_parameter(self.node, name, value), (name, value))
        self.assertTrue(eventually(lambda: self.node.got('config')[-1][name] == value), name)

    def test_diagnostics(self):
        """The node says what its logic says, the worse of two levels; a failure is ERROR."""
        if not self.diagnostics:
            return
        heard = self.peer.hear_diagnostics()
        begun = monotonic()
        node = self.start(frequency=5.0)  # in which busy machines have no late cycles

        def last(count=1):
            statuses = [each for message in heard for each in message.status]
            return [each for each in statuses if each.name == node.name][-count:]

        def says(level, text, said):
            for status in last():
                values = {each.key: each.value for each in status.values}
                is_level = status.level == level and text in status.message
                # Cycles of a busy machine are late, and topics without messages.
                late = 'late cycles'
                is_late = values.get(late, '0') != '0' and status.message.startswith(late)
                is_late |= status.message.startswith('no message on ')
                is_level |= level == OK and is_late
                own = status.hardware_id, values.get('said')
                return is_level and own == (said or 'none', said)
            return False

        def is_active():
            return says(OK, 'active', None) and last()[0].values[0].value == 'active'

        self.assertTrue(eventually(is_active), last())
        for word, level in ('error', ERROR), ('ok', OK), ('warning', WARN):
            node.order('now', f'diagnose={word},{word}')
            self.assertTrue(eventually(lambda: says(level, word, word)), (word, last()))
        if self.frequency:
            node.order('update', 'wait=0.3')  # late, and misses none
            self.assertTrue(eventually(lambda: says(WARN, 'late cycles', 'warning')), last())
            self.assertTrue(says(WARN, 'warning', 'warning'), last())  # both sentences
            node.order('update', 'wait=1.1')

            def are_counted():
                values = {each.key: each.value for each in last()[0].values}
                keys = 'rate (Hz)', 'late cycles', 'missed cycles'
                rate, late, missed = (float(values.get(key, 0)) for key in keys)
                is_apart = missed > late or 2 * late < self.turns(node=node)[0]
                is_counted = late > 0 and missed > 3 and is_apart
                is_counted &= 0.5 < rate < 8.5
                return is_counted and all('late cycles' in each.message for each in last(3))

            self.assertTrue(eventually(are_counted), last(3))
        lates = {}
        for _, member, deadline in self.lates():
            _, topic, type_, _, *qos, _ = next(self.each(member, node=node.name))
            late = 'no message on ' + self.named(self.interfaces[member][0], False)
            self.assertTrue(eventually(lambda: says(WARN, late, 'warning')), (late, last()))
            silence = last()[0].message.partition(late + ' for ')[2].partition(' s')[0]
            self.assertTrue(deadline - 0.06 < float(silence) < monotonic() - begun + 0.06, silence)
            lates[late] = self.peer.publisher(type_, topic, *qos), sample(type_, 1)

        def are_heard():
            for publisher, message in lates.values():
                publisher.publish(message)
            return not any(late in last()[0].message for late in lates)

        self.assertTrue(eventually(are_heard), last())

        def is_regular():
            own = [each for each in heard if each.status[0].name == node.name]
            times = [each.header.stamp.to_sec() for each in own]
            return any(0.8 < end - begin < 1.2 for begin, end in zip(times, times[1:]))

        self.assertTrue(eventually(is_regular), heard)  # once a second
        self.assertTrue(eventually(lambda: 'late cycles' not in last()[0].message), last())
        node.order('now', 'fail=lost')
        self.assertEqual(node.exit_code(), 1)
        self.assertTrue(eventually(lambda: says(ERROR, 'lost for good', 'warning')), last())
        node = self.start('configure block refuse')
        self.assertTrue(eventually(lambda: says(OK, 'unconfigured', None)), last())
        self.assertEqual(last()[0].values[0].value, 'unconfigured')
        node.order('now', 'release')
        self.assertTrue(eventually(lambda: says(ERROR, 'configure', None)), last())

    def test_ends(self):
        """The node ends as its logic and signals have it: exit code, calls and log."""
        ends = [  # order, stop_timeout, signals, exit code, calls, text of the log
            ('deactivate wait=2.5', 1e3, [INT], 0, LIFE, '["wait", null]'),
            ('configure refuse', 20.0, [], 1, LIFE[:1], 'refuse'),
            ('configure raise', 20.0, [], 1, LIFE[:1], 'in configure'),
            ('activate refuse', 20.0, [], 1, [*LIFE[:2], 'cleanup'], 'refuse'),
            ('activate raise', 20.0, [], 1, [*LIFE[:2], 'cleanup'], 'told to raise'),
            ('configure sleep=1000', 20.0, [TERM], 0, [LIFE[0], 'cleanup'], '["sleep", false]'),
            ('configure block', 0.1, [TERM], 1, LIFE[:1], 'stops: configure.'),
            ('deactivate sleep=1000', 0.1, [TERM], None, LIFE, '["sleep", false]'),
            ('deactivate raise=other', 20.0, [INT], 1, LIFE, 'in deactivate'),
            ('configure fail=lost', 20.0, [], 1, [LIFE[0], 'cleanup'], 'The logic failed: lost'),
            ('activate fail=lost', 20.0, [], 1, LIFE, 'The logic failed: lost'),
            ('cleanup raise', 20.0, [TERM], 1, LIFE, 'told to raise'),
            ('deactivate block', 2.0, [TERM], 1, LIFE[:3], 'stops: deactivate.'),
            ('deactivate block', 1e3, [INT, TERM], -TERM, LIFE[:3], ''),
            ('deactivate block', 1e3, [TERM, INT], -INT, LIFE[:3], ''),
            ('deactivate sleep=0.1', 20.0, [TERM], 0, LIFE, '["sleep", true]'),
            ('configure wait=0', -1.0, [], 1, [], 'stop_timeout'),
            ('configure wait=0', 3601.0, [], 1, [], 'stop_timeout'),
            ('deactivate wait=0.1', 20.0, ['rosnode kill'], 0, LIFE, '["wait", null]'),
        ]
        if self.frequency:
            ends.append(('update raise', 20.0, [], 1, LIFE, 'told to raise'))
            ends.append(('update sleep=1000', 20.0, [TERM], 0, LIFE, '["sleep", false]'))
            ends.append(('update sleep=1000 raise', 20.0, [TERM], 1, LIFE, 'told to raise'))
        callbacks = self.callbacks()
        for member in callbacks:
            ends.append((f'{member} raise', 20.0, [], 1, LIFE, 'told to raise'))
        for member, *_ in self.each('execute_'):
            ends.append((f'{member} await end=succeed raise', 20.0, [], 1, LIFE, 'told to raise'))
        for member, *_ in self.each('accept_'):
            ends.append((f'{member} raise', 20.0, [], 1, LIFE, 'told to raise'))
        for member in callbacks[:1]:
            ends.append((f'{member} block', 1.0, [TERM], 1, LIFE, 'Still running'))
            ends.append((f'{member} sleep=1000 raise', 20.0, [TERM], 1, LIFE, 'told to raise'))
            ends.append((f'{member} wait=0.5', 20.0, [TERM], 0, LIFE, '["wait", null]'))
        for member, *_ in self.each(*self.can_refuse):
            ends.append((f'{member} refuse', 20.0, [], 1, LIFE, 'no response'))
        for member in self.transforms:
            if member.startswith('listener_'):
                order = f'activate {member}=map,nowhere,1000'
                ends.append((order, 20.0, [INT], 0, LIFE, f'["{member}", "'))
        for member, _, type_ in self.each('client_'):
            order = f'activate {member}={encode(type_._request_class())},1000'
            ends.append((order, 20.0, [INT], 0, LIFE, f'["{member}", null]'))
        beside = [*self.threads, *self.timers, *(late for late, *_ in self.lates())]
        for method in beside:
            ends.append((f'{method} raise', 20.0, [], 1, LIFE, 'told to raise'))
            ends.append((f'{method} block', 1.0, [TERM], 1, LIFE, 'Still running'))
        if beside:  # their waits end together
            orders = '\n'.join(f'{method} sleep=1000' for method in beside) + '\nactivate wait=0.5'
            ends.append((orders, 20.0, [TERM], 0, LIFE, '["sleep", false]'))
        with ThreadPoolExecutor(8) as pool:
            list(pool.map(self.end, ends))

    def end(self, case):
        """Check how a node ends."""
        order, timeout, signals, code, calls, text = case
        method = order.split()[0]
        given = {} if timeout == 2.0 else {'stop_timeout': timeout}  # its default
        is_called = method.startswith(('receive_', 'serve_', 'execute_', 'accept_'))
        node = (self.active if is_called else self.start)(order, **given)
        if is_called:
            goal = self.trigger(node, method)
            self.assertFalse(method.startswith('accept_') and goal, order)
            if 'await' in order:
                goal.cancel()
                self.assertEqual(goal.end()[0], 'aborted')
        events = ('activate' if method in LIFE[1:] else 'begun', 'deactivate')
        for number, event in zip(signals, events):
            count = len(order.splitlines())
            self.assertTrue(eventually(lambda: len(node.got(event)) >= count), node.log)
            loops = self.frequency and method not in LIFE[:2]
            self.assertTrue(eventually(lambda: not loops or node.order('now', 'turns=update')[0]))
            begin = monotonic()
            self.peer.kill(node) if number == 'rosnode kill' else node.signal(number)
        if code == 1 and 'block' in order:
            self.assertTrue(eventually(lambda: text in node.log), (order, node.log))
            self.assertGreaterEqual(monotonic() - begin, timeout, order)
        ended = node.exit_code()
        self.assertEqual(ended if code is not None else None, code, (order, node.log))
        self.assertEqual(node.life(), calls, (order, node.log))
        self.assertIn(text, node.log, order)
        self.assertRegex(node.log, 'ERROR|FATAL' if code == 1 else '.')
        if is_called and 'wait=' in order:  # what came meanwhile has waited in vain
            self.assertEqual(len(node.got(method)), 1, (order, node.log))
        if '\nactivate' in order:  # none was called before its return
            steps = [name for name, _ in node.reports if name in ('begun', 'wait')]
            self.assertEqual(steps[:2], ['begun', 'wait'], node.log)
        self.assertTrue(calls or 'Traceback' not in node.log, node.log)

    def test_failure(self):
        """The logic writes to the log; one that fails ends the node in order, with exit code 1."""
        node = self.active(log_level='debug')
        for level in 'debug', 'info', 'warning', 'error':
            node.order('now', 'log')
            self.assertTrue(eventually(lambda: f'said as {level}' in node.log), node.log)
            for said in f'said as {level}', 'said once':
                self.assertRegex(node.log, rf'{level[:4].upper()}\w*\] .*{said}')
        self.assertEqual(node.log.count('said once'), 4, node.log)
        begin = monotonic()
        self.assertTrue(node.order('now', 'sleep=0.5'))
        self.assertGreaterEqual(monotonic() - begin, 0.5)
        node.order('now', 'fail=lost')
        self.assertEqual((node.exit_code(), node.life()), (1, LIFE), node.log)
        self.assertIn('The logic failed: lost', node.log)

    def test_launch_files(self):
        """The launch files name programs and files that the package has."""
        package = re.search('<name>(.*)</name>', (self.root / 'package.xml').read_text())[1]
        build = [self.root / 'CMakeLists.txt', self.root / 'setup.py']
        built = ''.join(each.read_text() for each in build if each.exists())
        for launch in self.root.glob('launch/*.launch'):
            text = launch.read_text()
            for program in re.findall(rf'pkg="{package}" type="([^"$]+)"', text):
                is_built = re.search(rf"[\s'\"/(]{re.escape(program)}\b", built)
                self.assertTrue(is_built or [*self.root.rglob(program)], f'{launch}: {program}')
            for path in re.findall(rf"\b{package}(?:'\) \+ '|\))/([\w./-]+)['\"]", text):
                self.assertTrue((self.root / path).exists(), f'{launch}: {path}')

    def test_own_logic(self):
        """The node runs with its own logic and its files in config/; SIGTERM ends it well."""
        config = self.root / 'config'
        for file in self.parameter_files:
            given = yaml.safe_load((config / file).read_text()) or {}
            known = {
                'frequency',
                'stop_timeout',
                'log_level',
                *self.parameters,
                *self.dynamic_parameters,
            }
            own = {name for name, value in given.items() if not isinstance(value, dict)}
            self.assertLessEqual(own, known, file)
            node = self.start(_command=self.logic, **given)
            ready = node.eventually(lambda: self.peer.knows(node) and node.handles(TERM))
            self.assertTrue(ready, node.log)
            sleep(1.0)  # in which the logic may refuse
            node.signal(TERM)
            self.assertEqual(node.exit_code(), 0, node.log)
