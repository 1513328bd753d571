"""A stand-in for IRIT's end of a conversation, written from the protocol.

It listens, accepts a client, writes requests in many small pieces as IRIT does,
and reads answers as strictly as IRIT: what would hang IRIT or end its script is
a Hang or an Error here. Objects are ('num', x), ('str', s), ('list', [...]) or
('geo', text), text being the lines of an entity."""
import socket
import struct
import time

HEAD = 'IRITX/1'


class Hang(Exception):
    """IRIT would wait for ever."""


class Error(Exception):
    """IRIT would end the script."""


class Silence(Exception):
    """IRIT would run into its time-out."""


def num(x):
    return ('num', x)


def string(s):
    return ('str', s)


def lst(*items):
    return ('list', list(items))


def geo(text):
    return ('geo', text)


def request(seq, op, *args):
    return lst(string(HEAD), num(seq), string(op), lst(*args))


# --- text, as IRIT writes it ------------------------------------------------

def write_text(o, name='NONE'):
    """One line an entity, strings not escaped, an empty list without a body."""
    kind, value = o
    head = '[OBJECT %s\n' % name
    if kind == 'num':
        text = 'nan' if value != value else '%.17g' % value
        return head + '[NUMBER %s]\n]\n' % text
    if kind == 'str':
        return head + '[STRING "%s"]\n]\n' % value
    if kind == 'list':
        return head + ''.join(write_text(v, 'X%d' % i) for i, v in enumerate(value)) + ']\n'
    return head + value + ']\n'


# --- text, as IRIT reads it -------------------------------------------------

class Reader:
    """Reads one object; next_byte() gives an int, or raises."""

    def __init__(self, next_byte):
        self.next_byte, self.back, self.after_close = next_byte, None, False
        self.lines = []

    def get(self):
        c, self.back = (self.back, None) if self.back is not None else (self.next_byte(), None)
        if c == 13:
            raise Error('carriage return')
        if c < 32 and c not in (9, 10):
            raise Error('control byte %d' % c)
        if c == 255:
            raise Error('byte 255')
        return c

    def token(self):
        """'[' , ']' , ('word', s) or ('quoted', s)."""
        c = self.get()
        if self.after_close and c == 0x5d:
            raise Hang(']]')
        while c in b' \t\n':
            c = self.get()
        self.after_close = False
        if c == 0x5b:
            return '['
        if c == 0x5d:
            self.after_close = True
            return ']'
        if c == 0x22:
            return ('quoted', self.quoted())
        word = bytearray()
        while c not in b' \t\n[]':
            word.append(c)
            c = self.get()
        self.back = c
        return ('word', word.decode('latin-1'))

    def quoted(self):
        s = bytearray()
        while True:
            c = self.get()
            if c == 0x22:
                break
            if c == 10:
                raise Error('a string ends at the line')
            s.append(self.get() if c == 0x5c else c)
        if len(s) >= 4096:
            raise Error('String too long')
        return s.decode('latin-1')

    def object(self):
        """The object behind its first bracket, which has been read."""
        if self.token() != ('word', 'OBJECT'):
            raise Hang('a bare entity')
        t = self.token()
        while t == '[':
            self.skip()
            t = self.token()
        if t[0] != 'word':
            raise Hang('no name')
        if t[1] != 'NONE':
            raise Error('the name %s would become a variable' % t[1])
        o = self.body()
        return o

    def skip(self):
        depth = 1
        while depth:
            t = self.token()
            depth += (t == '[') - (t == ']')

    def body(self):
        """Objects, or entities; None for an empty object."""
        t = self.token()
        if t == ']':
            return None
        if t != '[':
            raise Error('no entity')
        word = self.token()
        if word == ('word', 'OBJECT'):
            return self.list()
        o = self.entity(word)
        while self.token() == '[':
            self.entity(self.token())
        return o

    def list(self):
        items, first = [], True
        while True:
            if first:
                t = self.token()
                while t == '[':
                    self.skip()
                    t = self.token()
                if t != ('word', 'NONE'):
                    raise Error('name %s' % (t,))
                o = self.body()
            else:
                o = self.object()
            if o is not None:
                items.append(o)
            first = False
            t = self.token()
            if t == ']':
                return ('list', items)
            if t != '[':
                raise Error('junk in a list')

    def entity(self, word):
        if word == ('word', 'NUMBER'):
            x = float(self.token()[1])
            if self.token() != ']':
                raise Error('] of NUMBER')
            return ('num', x)
        if word == ('word', 'STRING'):
            s = self.token()
            if s[0] != 'quoted' or self.token() != ']':
                raise Error('STRING')
            return ('str', s[1])
        out, depth = [word[1]], 1
        while depth:
            t = self.token()
            depth += (t == '[') - (t == ']')
            out.append(t if isinstance(t, str) else t[1])
        return ('geo', out)

    def message(self):
        """What is before the bracket is skipped; behind the last one must be a
        blank."""
        while self.get() != 0x5b:
            pass
        o = self.object()
        if o is None:
            raise Error('an empty object')
        if self.next_byte() not in b' \n\t':
            raise Hang('no newline behind the last bracket')
        return o


def read_text(data):
    """One object in a file."""
    it = iter(data)

    def next_byte():
        for c in it:
            return c
        raise Hang('the data end')
    return Reader(next_byte).message()


# --- binary -------------------------------------------------------------------

def sync(t):
    return struct.pack('<I', 0x43168000 | t)


def pad(s):
    b = s.encode('latin-1') + b'\0'
    b += b'\0' * (-len(b) % 8)
    return sync(211) + struct.pack('<i', len(b)) + b


CODE = {'num': 2, 'str': 9, 'list': 10}


def write_binary(o, name=''):
    """A ('geo', bytes) is a record by itself."""
    kind, value = o
    if kind == 'geo':
        return value
    st = bytearray(272)
    struct.pack_into('<i', st, 32, CODE[kind])
    if kind == 'num':
        struct.pack_into('<d', st, 88, value)
    if kind == 'list':
        struct.pack_into('<i', st, 96, len(value) + 3)
    b = sync(CODE[kind]) + bytes(st) + pad(name) + sync(200)
    if kind == 'str':
        b += pad(value) + sync(200)
    if kind == 'list':
        b += sync(212) + struct.pack('<%dQ' % (len(value) + 3), *([0xdead] * len(value) + [0] * 3))
        b += b''.join(write_binary(v, 'X') for v in value)
    return b


class BinaryReader:
    """take(n) gives n bytes. Entities other than numbers, strings and lists end
    what is read: rest holds nothing of them."""

    def __init__(self, take):
        self.take = take

    def want(self, t):
        w, = struct.unpack('<I', self.take(4))
        if w != 0x43168000 | t:
            raise Error('Fail to sync: %08x, record %d is due' % (w, t))

    def text(self):
        self.want(211)
        n, = struct.unpack('<i', self.take(4))
        return self.take(n).split(b'\0')[0].decode('latin-1')

    def object(self):
        w, = struct.unpack('<I', self.take(4))
        t = w & 255
        if w & 0xffffff00 != 0x43168000:
            raise Error('Fail to sync: %08x' % w)
        st = self.take(272)
        if self.text():
            raise Error('a name')
        self.want(200)
        if t == 2:
            return ('num', struct.unpack_from('<d', st, 88)[0])
        if t == 9:
            s = self.text()
            self.want(200)
            return ('str', s)
        if t != 10:
            return ('record', t)
        self.want(212)
        cap, = struct.unpack_from('<i', st, 96)
        n = sum(p != 0 for p in struct.unpack('<%dQ' % cap, self.take(8 * cap)))
        items = []
        for _ in range(n):
            items.append(self.object())
            if items[-1][0] == 'record':
                break
        return ('list', items)


def read_binary(data):
    at = [0]

    def take(n):
        at[0] += n
        if at[0] > len(data):
            raise Hang('the data end')
        return data[at[0] - n:at[0]]
    return BinaryReader(take).object()


# --- the connection -------------------------------------------------------------

class Server:
    """The listening socket of one session."""

    def __init__(self):
        self.s = socket.socket()
        self.s.bind(('127.0.0.1', 0))
        self.s.listen(50)
        self.s.settimeout(10)
        self.port = self.s.getsockname()[1]

    def accept(self, binary=False):
        return Client(self.s.accept()[0], binary)

    def close(self):
        self.s.close()


class Client:
    """IRIT's end of one connection."""

    def __init__(self, s, binary):
        self.s, self.binary, self.seq = s, binary, 0
        self.buf, self.at = bytearray(), 0  # what came; read up to there (text)
        self.wait = 20.0

    def write(self, o, pieces=True, name='NONE'):
        self.s.settimeout(60)
        if self.binary:
            self.s.sendall(write_binary(o, '' if name == 'NONE' else name))
            return
        data = write_text(o, name).encode('latin-1')
        if not pieces:
            self.s.sendall(data)
            return
        for line in data.splitlines(True):
            self.s.send(line)

    def more(self, timeout):
        """Polls every 10 ms, as IRIT does."""
        self.s.settimeout(0.01)
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            try:
                data = self.s.recv(1 << 18)
            except socket.timeout:
                continue
            if not data:
                raise EOFError('the client has left')
            self.buf += data
            return
        raise Silence('No data (timeout)')

    def take(self, n):
        while len(self.buf) < n:
            self.more(self.wait)
        data = bytes(self.buf[:n])
        del self.buf[:n]
        return data

    def byte(self):
        if self.at == len(self.buf):
            self.buf.clear()
            self.at = 0
            self.more(self.wait)
        self.at += 1
        return self.buf[self.at - 1]

    def idle(self):
        """Has all that came been read?"""
        return self.at == len(self.buf)

    def read(self):
        if self.binary:
            return BinaryReader(self.take).object()
        return Reader(self.byte).message()

    def ask(self, op, *args, pieces=True):
        """Status and value of one request; older answers are dropped."""
        self.seq += 1
        self.write(request(self.seq, op, *args), pieces)
        return self.answer(self.seq)

    def answer(self, seq):
        for _ in range(100000):
            o = self.read()
            assert o[0] == 'list' and o[1][0] == ('str', HEAD), o
            if o[1][1] == ('num', seq):
                assert len(o[1]) == 4, o
                return int(o[1][2][1]), o[1][3]
        raise Error('only old answers')

    def quiet(self, seconds):
        """Nothing may come unasked."""
        try:
            self.more(seconds)
        except Silence:
            return self.idle()
        return False

    def farewell(self, text='EXIT'):
        self.write(string(text), name='COMMAND_')

    def reset(self):
        self.s.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack('ii', 1, 0))
        self.s.close()

    def close(self):
        self.s.close()
