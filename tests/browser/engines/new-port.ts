// A port for a server, and with it an origin, that no test of this worker had before. The system gives out a port again
// after some hundred others, and a browser that serves all tests still has what an earlier test stored there.
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';

const given = new Set<number>();

/** The number of the port; the server listens on it, and is heard on this machine alone. */
export async function listenOnNewPort(server: Server): Promise<number> {
  for (;;) {
    await new Promise<void>((resolve, reject) => {
      server.once('error', reject);
      server.listen(0, '127.0.0.1', () => {
        server.off('error', reject);
        resolve();
      });
    });
    const { port } = server.address() as AddressInfo;
    if (!given.has(port)) {
      given.add(port);
      return port;
    }
    await new Promise((closed) => server.close(closed));
  }
}
