"""driver - a page in headless Chromium, moved by chromedriver (WebDriver, W3C 2018)
with nothing but the standard library; screenshots as rows of pixels."""
import base64
import json
import socket
import struct
import subprocess
import time
import urllib.error
import urllib.request
import zlib


def free_port():
    with socket.socket() as s:
        s.bind(('127.0.0.1', 0))
        return s.getsockname()[1]


def unfilter(raw, stride, size, height):
    """Rows of a PNG's bytes, whose filters are undone (PNG 1.2, 6)."""
    rows, above = [], bytearray(stride)
    for y in range(height):
        at = y * (stride + 1)
        filt, row = raw[at], bytearray(raw[at + 1:at + 1 + stride])
        for x in range(stride if filt else 0):
            a, b = row[x - size] if x >= size else 0, above[x]
            c = above[x - size] if x >= size else 0
            p = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[x] = (row[x] + (0, a, b, (a + b) // 2, p)[filt]) & 255
        rows.append(row)
        above = row
    return rows


class Picture:
    def __init__(self, data):
        self.width, self.height, _, kind = struct.unpack('>IIBB', data[16:26])
        size, at, packed = {2: 3, 6: 4}[kind], 8, b''
        while at < len(data):
            n, = struct.unpack('>I', data[at:at + 4])
            if data[at + 4:at + 8] == b'IDAT':
                packed += data[at + 8:at + 8 + n]
            at += n + 12
        self.size = size
        self.rows = unfilter(zlib.decompress(packed), self.width * size, size, self.height)

    def where(self, wanted, left=0):
        """Places (x, y), x >= left, of the pixels for which wanted(r, g, b)."""
        n = self.size
        return [(x, y) for y, row in enumerate(self.rows) for x in range(left, self.width)
                if wanted(*row[x * n:x * n + 3])]


class Browser:
    def __init__(self, chromedriver, chromium, profile):
        self.port, self.session = free_port(), ''
        self.proc = subprocess.Popen([chromedriver, '--port=%d' % self.port],
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        args = ['--headless', '--no-sandbox', '--use-angle=swiftshader',
                '--enable-unsafe-swiftshader', '--window-size=900,600',
                '--user-data-dir=' + profile]
        wish = {'goog:chromeOptions': {'args': args, 'binary': chromium},
                'goog:loggingPrefs': {'browser': 'ALL'}}
        for _ in range(50):
            try:
                made = self.call('/session', {'capabilities': {'alwaysMatch': wish}})
                break
            except urllib.error.HTTPError:
                raise
            except urllib.error.URLError:
                time.sleep(0.1)
        else:
            raise OSError('chromedriver does not answer')
        self.session = '/session/' + made['sessionId']

    def call(self, path, body=None, method=None):
        data = None if body is None else json.dumps(body).encode()
        ask = urllib.request.Request('http://127.0.0.1:%d%s%s' % (self.port, self.session, path),
                                     data, {'Content-Type': 'application/json'}, method=method)
        with urllib.request.urlopen(ask, timeout=60) as answer:
            return json.load(answer)['value']

    def open(self, address, title):
        self.call('/url', {'url': address})
        for _ in range(100):
            if self.call('/title') == title:
                return
            time.sleep(0.1)
        raise OSError('the page does not become ready; its console says:\n' + self.console())

    def js(self, text):
        return self.call('/execute/sync', {'script': text, 'args': []})

    def click(self, selector):
        self.js('document.querySelector(%s).click()' % json.dumps(selector))
        time.sleep(0.8)  # until views have moved and the picture is drawn

    def console(self):
        return '\n'.join(line['message'] for line in self.call('/se/log', {'type': 'browser'}))

    def picture(self):
        return Picture(base64.b64decode(self.call('/screenshot')))

    def drag(self, x, y, dx, dy):
        moves = [{'type': 'pointerMove', 'duration': 0, 'x': x, 'y': y},
                 {'type': 'pointerDown', 'button': 0},
                 *({'type': 'pointerMove', 'duration': 60, 'x': x + dx * i // 5, 'y': y + dy * i // 5}
                   for i in range(1, 6)),
                 {'type': 'pause', 'duration': 400},  # so that it does not spin on
                 {'type': 'pointerUp', 'button': 0}]
        self.call('/actions', {'actions': [{'type': 'pointer', 'id': 'mouse', 'actions': moves,
                                            'parameters': {'pointerType': 'mouse'}}]})
        time.sleep(0.5)

    def wheel(self, x, y, dy):
        roll = {'type': 'scroll', 'x': x, 'y': y, 'deltaX': 0, 'deltaY': dy, 'duration': 0}
        self.call('/actions', {'actions': [{'type': 'wheel', 'id': 'wheel', 'actions': [roll]}]})
        time.sleep(0.8)

    def close(self):
        try:
            if self.session:
                self.call('', method='DELETE')
        except OSError:
            pass
        self.proc.kill()
        self.proc.wait()
