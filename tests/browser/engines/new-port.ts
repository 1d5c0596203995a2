// Listens on a port that no earlier test of this worker has used, so that the origin is new. The system reuses ports
// after some hundred others, and the shared browser still has the storage of earlier tests.
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';

const given = new Set<number>();

/** Listens on the loopback interface and returns the number of the port. */
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
