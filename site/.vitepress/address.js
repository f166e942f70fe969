// The only place with the addresses of the repository and of the site. Until both have one, they are
// placeholders.

/** Where files that are not on the site are found. */
export const repository = 'https://example.com/shaderlint';

/** Address of the site. Its path is the folder of the server that the site is in. */
export const site = process.env.SITE || 'https://example.com/';

/** The path alone: `/`, or `/shaderlint/`. */
export const base = new URL(site).pathname;

/** The address of a file of the repository. */
export const source = (file) => `${repository}/blob/HEAD/${file}`;
