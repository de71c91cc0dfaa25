# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Runs a node with a logic that writes its calls to stdout: recorder.py NODE CLASS ARGUMENTS."""

from importlib import import_module
import sys
from threading import Thread
from time import monotonic, sleep
from typing import get_args, get_type_hints


def record(name, words=''):
    """Write a line for the test, in one call, as other threads write too."""
    sys.stdout.write(f'called {name} {words}\n')
    sys.stdout.flush()


def recorder(impl_type):
    """Return a class that records the calls of the logic, to use instead of `impl_type`."""

    class Recorder(impl_type):
        """Refuses nothing, publishes every output, and serves every request at once."""

        def __init__(self, passthrough):
            self.passthrough = passthrough
            self.config = None
            self.is_active = False
            self.updates = 0
            self.start = 0.0

        def configure(self, config):
            self.config = config
            record('configure', ascii(config))
            return True

        def activate(self):
            self.updates = 0
            self.start = monotonic()
            self.is_active = True
            for name, type_ in get_type_hints(type(self.passthrough)).items():
                if name.startswith('client_'):
                    arguments = (name, get_args(type_)[0])
                    Thread(target=self.call, args=arguments, daemon=True).start()
            record('activate')
            return True

        def call(self, name, request_type):
            client = getattr(self.passthrough, name)
            while self.is_active:
                if client.call(request_type()) is not None:
                    record(name)
                    return
                sleep(0.1)

        def update(self, data, config):
            self.updates += 1
            for name, value in vars(data).items():
                if name.endswith('_updated') and value is True:
                    record(name)
            if config != self.config:
                self.config = config
                record('config', ascii(config))

        def deactivate(self):
            self.is_active = False
            record('rate', self.updates / (monotonic() - self.start))
            record('deactivate')

        def cleanup(self):
            record('cleanup')

    def callback(name):
        def receive_or_execute(_self, item):
            record(name)
            if name.startswith('execute_'):
                item.succeed()

        def serve(_self, _request, response):
            record(name)
            return response

        return serve if name.startswith('serve_') else receive_or_execute

    for name in dir(impl_type):
        if name.startswith(('receive_', 'serve_', 'execute_')):
            setattr(Recorder, name, callback(name))
    return Recorder


if __name__ == '__main__':
    node = import_module('all_kinds.' + sys.argv.pop(1) + '_ros')
    impl = sys.argv.pop(1)
    setattr(node, impl, recorder(getattr(node, impl)))
    sys.exit(node.main())
