// Keeps the site for use without a network, and asks before a newer one is used.
//
// What is written before this text when the site is built:
//   VERSION  names the contents of the site, this text included
//   FILES    its files, each with its digest: address relative to this script -> Subresource Integrity
//
// Each version has a cache of its own, filled when the version is installed and never changed after. The digests see to
// it that a cache holds the files of one version, whatever the server had at that moment. A version that could not be
// fetched whole is not installed: the one before stays.
//
// Files that a page may ask for long after it has started have the version in their address. So a page goes on in its
// own version when a newer one takes over because a user accepted it in another tab.

/** Caches belong to the whole origin, which other sites may share: ours begin with this. */
const OURS = `motionbench ${self.registration.scope} `;
const CACHE = OURS + VERSION;

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(Promise.all([self.clients.claim(), tidy()])));

// From a page: `accept` when the user wants this version, `tidy` when a page has started.
self.addEventListener("message", (event) => {
  if (event.data === "accept") {
    event.waitUntil(self.skipWaiting());
  } else if (event.data === "tidy") {
    event.waitUntil(tidy());
  }
});

self.addEventListener("fetch", (event) => {
  const address = kept(event.request);
  if (address !== null) {
    event.respondWith(answer(event.request, address));
  }
});

async function install() {
  const cache = await caches.open(CACHE);
  try {
    await Promise.all(Object.entries(FILES).map(([name, integrity]) => keep(cache, name, integrity)));
  } catch (error) {
    await caches.delete(CACHE);
    throw error;
  }
}

async function keep(cache, name, integrity) {
  const address = new URL(name, self.registration.scope).href;
  // The page has just loaded most files, so the browser has them. What it has from another version fails the digest.
  const response = await fetch(address, { integrity }).catch(() => fetch(address, { integrity, cache: "reload" }));
  if (!response.ok) {
    throw new Error(`${address} answers ${response.status}`);
  }
  const { status, statusText, headers } = response;
  // A browser refuses to show a page from an answer that was redirected.
  await cache.put(address, response.redirected ? new Response(response.body, { status, statusText, headers }) : response);
}

/** The address under which a requested file is kept, or null for what is none of this site's. */
function kept(request) {
  const { scope } = self.registration;
  if (request.method !== "GET" || !request.url.startsWith(scope)) {
    return null;
  }
  const url = new URL(request.url);
  const address = url.origin + url.pathname;
  return address === `${scope}index.html` ? scope : address;
}

async function answer(request, address) {
  return (await caches.match(address, { cacheName: CACHE })) ?? (await elsewhere(address)) ?? fetch(request);
}

/** What another version keeps under an address: one that a page still uses. */
async function elsewhere(address) {
  for (const cacheName of await ours()) {
    const found = await caches.match(address, { cacheName });
    if (found) {
      return found;
    }
  }
  return undefined;
}

async function ours() {
  return (await caches.keys()).filter((name) => name.startsWith(OURS));
}

/** Deletes the caches of older versions, but those that a page uses. */
async function tidy() {
  const names = await ours();
  // What a still newer version has put there must stay; it tidies when it takes over.
  if (self.registration.installing || self.registration.waiting) {
    return;
  }
  // Every page holds a lock that is named as its version's cache.
  const { held } = await navigator.locks.query();
  const used = new Set(held.map((lock) => lock.name));
  const old = names.filter((name) => name !== CACHE && !used.has(name));
  await Promise.all(old.map((name) => caches.delete(name)));
}
